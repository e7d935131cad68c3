// Declares what all parts of the library share: places, warnings, errors, and the context of a computation.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#define KEYBLOCK_API __attribute__((visibility("default")))

namespace keyblock::api {
inline namespace v1 {

/// A place in a text file; line and column count from 1, 0: the file as a whole. Or a choice of the caller; `file` is
/// its text then.
struct Place {
  std::string file;
  int line = 0, column = 0;
  std::string choice = {};  ///< of the caller, such as "histories"; empty for a file
};

/// Values behind a sentence: numbers by name, numbers of blocks or elements, points, and names by kind ("layer").
struct Facts {
  std::vector<std::pair<std::string, double>> numbers = {};
  std::vector<int> blocks = {};
  std::vector<std::array<double, 2>> points = {};
  std::vector<std::pair<std::string, std::string>> names = {};
};

/// Usable input that is likely a mistake, or a doubt: `code` is a stable word (`keyblock explain CODE` has the remedy).
struct Warning {
  std::string code, sentence;
  Place place;
  std::string level = {};  ///< "error": results are unreliable; "warning": the user should act; "note"; "silent"
  Facts facts = {};        ///< empty if the sentence has no values
};

/// Kinds of errors, each with the exit code of the program.
enum class ErrorCode {
  input,    ///< 3: a file, or a case, that cannot be used
  choice,   ///< 2: an unknown setting, profile, pointer or column, or a choice that cannot be fulfilled
  output,   ///< 4: results that cannot be written
  stopped,  ///< 130: `Context::stop` ended a computation before it had a result
  failed,   ///< 4: all else, such as a search without an answer
};

/// The only exception of the library, beside std::bad_alloc. `what()` is a sentence; for input
/// "file:line:column: error: expected …, found …".
struct KEYBLOCK_API Error : std::runtime_error {
  explicit Error(const std::string& what, ErrorCode of = ErrorCode::failed, Place at = {}, std::size_t choice_from = 0)
      : std::runtime_error(what), code(of), place(std::move(at)), choice_at(choice_from) {}
  ErrorCode code;
  Place place;                ///< of the input or the choice; empty where there is none
  std::size_t choice_at = 0;  ///< where `what()` names `place.choice`
};

/// Stops a computation and limits its threads. Copies share one state; any thread may use it.
class KEYBLOCK_API Context {
 public:
  /// Threads of a step, at most 256; 0: as many as there are processors. Results do not depend on it, to the last bit.
  /// Throws choice.
  explicit Context(int threads = 0);
  /// Stops steps and searches, and is not taken back. May be called by a signal handler.
  void stop() const noexcept;
  bool is_stopped() const noexcept;
  /// Name of the search that runs and its progress, 0 to 1 (0: unknown). The name is empty between searches.
  std::pair<std::string, double> headway() const;

  struct State;
  const State& state() const { return *state_; }

 private:
  std::shared_ptr<State> state_;
};

}  // namespace v1
}  // namespace keyblock::api
