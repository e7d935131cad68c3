// Declares the context of a computation: stop requests, limits, progress, threads of loops, folder of input files.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <filesystem>
#include <memory>
#include <optional>

namespace keyblock {

struct LoopThreads;  // base/loop_threads

/// Thrown out of unfinished work; the state before it is unchanged.
class StopRequested : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped by request"; }
};

/// Progress of a long search, shown while no step ends.
struct Headway {
  const char* what = nullptr;  ///< a few words; null: no progress is reported
  double share = 0;            ///< completed fraction, up to 1; 0: unknown
};

/// Returns the share of the way from `first` down to `goal`, in orders of magnitude, which a search covers evenly.
double share_of_fall(double first, double now, double goal);

/// Limits of a computation. A count of linear solves does not depend on the machine or its load, as seconds do.
struct Limits {
  std::optional<double> seconds = {};     ///< from now on, by the clock
  std::optional<long long> systems = {};  ///< number of linear solves
};

/// Context of a computation. Copies share one state; two contexts are independent. Any thread may call any function
/// except `use_threads`; a signal handler may call `stop`.
class Context {
 public:
  Context();
  explicit Context(Limits limits);

  /// Returns the context of a part of this computation, with limits of its own. A stop of the whole stops the part, not
  /// vice versa. Progress of the part is that of the whole, and its linear solves count there too.
  Context part(Limits limits = {}) const;

  void stop() const noexcept;
  /// Returns true after `stop` of this context or of the whole, and beyond the limit of seconds.
  bool is_stopped() const noexcept;

  /// Counts one linear solve. Throws StopRequested, and counts nothing, if it is stopped or the limit of solves is
  /// reached.
  void begin_system() const;
  long long systems() const noexcept;  ///< begun so far

  /// Reports progress. `what` must stay in memory; null ends the report.
  void tell(const char* what, double share) const noexcept;
  Headway headway() const noexcept;

  /// Sets the threads of loops, also for later parts; 0, the default: one per processor. Must be called while no loop
  /// runs.
  void use_threads(int count) const;
  LoopThreads& threads() const;

  /// Sets the folder from which relative paths of input files count, also in later parts. Empty, the default: the
  /// working directory, which is never changed.
  void use_folder(const std::filesystem::path& folder) const;
  const std::filesystem::path& folder() const;

 private:
  struct State;
  explicit Context(std::shared_ptr<State> state);

  std::shared_ptr<State> state_;
};

/// Returns the context of the calling thread: that of the innermost living `Under`, else one shared by all such
/// threads. Loops (base/loop) and threads (base/parallel) use the context of their caller.
const Context& context();

/// Returns the path of an input file, seen from the folder of the context.
std::filesystem::path located(const std::filesystem::path& input);

/// Puts the thread that creates it under a context, which must live as long, until it is destroyed.
class Under {
 public:
  explicit Under(const Context& context);
  explicit Under(Context&&) = delete;
  ~Under();
  Under(const Under&) = delete;
  Under& operator=(const Under&) = delete;

 private:
  const Context* before_;
};

/// Throws StopRequested if a stop was requested. Loops of long computations call it.
void leave_if_stopped();

/// Counts a linear solve; to be called before each one.
inline void begin_system() {
  context().begin_system();
}

/// Reports the progress of a search to the context of the thread (`Context::tell`).
inline void tell_headway(const char* what, double share) {
  context().tell(what, share);
}

}  // namespace keyblock
