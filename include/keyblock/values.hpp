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

/// A place in a text file; line and column count from 1, 0: the file as a whole.
struct Place {
  std::string file;
  int line = 0, column = 0;
  std::string choice = {};  ///< of the caller, such as "histories", with the text in `file`; empty for a file
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

struct KEYBLOCK_API Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// Input that cannot be used: `what()` is "file:line:column: error: expected …, found …".
struct KEYBLOCK_API InputError : Error {
  InputError(const std::string& what, Place at) : Error(what), place(std::move(at)) {}
  Place place;
};
/// An unknown setting, profile or pointer, or a choice that cannot be fulfilled.
struct KEYBLOCK_API SettingError : Error {
  explicit SettingError(const std::string& what, std::string of = {}, std::size_t at = 0)
      : Error(what), choice(std::move(of)), choice_at(at) {}
  std::string choice;         ///< that `what()` names, such as "histories"; empty without one
  std::size_t choice_at = 0;  ///< where in `what()`
};
/// Thrown by what `Context::stop` ends before it has a result.
struct KEYBLOCK_API Stopped : Error {
  using Error::Error;
};

/// Stops a computation and limits its threads. Copies share one state; any thread may use it.
class KEYBLOCK_API Context {
 public:
  /// Threads of a step, at most 256; 0: as many as there are processors. Results do not depend on it, to the last bit.
  /// Throws SettingError.
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
