// What a computation works under: who stops it, how far it tells that it is, how many threads its loops have.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <filesystem>
#include <memory>
#include <optional>

namespace keyblock {

struct LoopThreads;  // base/loop

/// Thrown out of work that is left half done; what held before it still holds.
class StopRequested : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped by request"; }
};

/// How far a long search is, for whoever shows progress while no step ends.
struct Headway {
  const char* what = nullptr;  ///< a few words; null: nothing is told
  double share = 0;            ///< of the way, up to 1; 0: not known
};

/// Returns the share of the way from `first` down to `goal`, in orders of magnitude, which a search covers evenly.
double share_of_fall(double first, double now, double goal);

/// What ends a computation early. A count of linear systems does not depend on the machine or its load, as seconds do.
struct Limits {
  std::optional<double> seconds = {};     ///< from now on, by the clock
  std::optional<long long> systems = {};  ///< linear systems that are solved
};

/// Copies share one state; two contexts know nothing of each other. Any thread may call any function but `use_threads`,
/// and a signal handler `stop`.
class Context {
 public:
  Context();
  explicit Context(Limits limits);

  /// A part of this computation, with limits of its own. Whatever stops the whole stops it; what stops it does not stop
  /// the whole. Its headway is that of the whole, and the systems that it solves count there too.
  Context part(Limits limits = {}) const;

  void stop() const noexcept;
  /// True after `stop`, of this one or of what it is a part of, and beyond the limit of seconds.
  bool is_stopped() const noexcept;

  /// Counts one linear system. Throws StopRequested, and counts nothing, where it is stopped or has solved as many as
  /// the limit allows.
  void begin_system() const;
  long long systems() const noexcept;  ///< begun so far

  /// `what` must stay where it is; null: nothing is told any more.
  void tell(const char* what, double share) const noexcept;
  Headway headway() const noexcept;

  /// Threads of loops, also of parts that are made from here on; 0, as at first: as many as there are processors. To be
  /// called while no loop runs.
  void use_threads(int count) const;
  LoopThreads& threads() const;

  /// Relative paths of input files count from this folder, also in parts that are made from here on. Empty, as at
  /// first: from the working directory, which nothing changes.
  void use_folder(const std::filesystem::path& folder) const;
  const std::filesystem::path& folder() const;

 private:
  struct State;
  explicit Context(std::shared_ptr<State> state);

  std::shared_ptr<State> state_;
};

/// The context of the calling thread: that of the innermost `Under` that lives, else one that all such threads share.
/// Loops (base/loop) and threads (base/parallel) work under that of their caller.
const Context& context();

/// The path of an input file, seen from the folder of the context.
std::filesystem::path located(const std::filesystem::path& input);

/// While it lives, the thread that made it works under a context, which must live as long.
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

/// For the loops of long computations: throws StopRequested where a stop was asked for.
void leave_if_stopped();

/// To be called before each linear system is solved.
inline void begin_system() {
  context().begin_system();
}

/// Tells the context of the thread how far a search is (`Context::tell`).
inline void tell_headway(const char* what, double share) {
  context().tell(what, share);
}

}  // namespace keyblock
