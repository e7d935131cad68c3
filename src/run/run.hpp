// A problem from its first state to its last: steps made one after another, handed to an observer as they come.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "problem/blocks.hpp"
#include "problem/problem.hpp"
#include "result/contact_frame.hpp"
#include "result/field_frame.hpp"
#include "result/frame.hpp"
#include "result/history.hpp"
#include "result/ledger.hpp"
#include "result/start_report.hpp"
#include "result/step_report.hpp"
#include "step/stepper.hpp"

namespace keyblock {

/// Who is told what. Any may be left empty.
struct Observer {
  std::function<void(const Frame&)> on_frame;
  std::function<void(const StepReport&)> on_step;
  /// At the start and after every step; where nothing is measured the rows hold all centroids, and come with the
  /// frames.
  std::function<void(const HistoryRow&)> on_row;
  std::function<void(const LedgerRow&)> on_ledger;  ///< at the start and after every step, if the settings ask for it
  /// Before every step, and where the run is stopped: what was told so far and this stepper are all that going on
  /// takes.
  std::function<void(Stepper&)> between_steps = {};
  /// Before each frame: the same instant within the elements.
  std::function<void(const FieldFrame&)> on_field = {};
  std::function<void(const ContactFrames&)> on_contacts = {};  ///< before each frame
  std::function<void(const Stepper&)> on_state = {};           ///< at the start and after every step
};

enum class RunEnd { finished, failed, stopped };

struct RunOutcome {
  RunEnd end = RunEnd::finished;
  std::string reason;                 ///< why it failed; empty otherwise
  std::vector<std::size_t> contacts;  ///< contacts (from 0) that would not settle
  FailureKind failure = FailureKind::undecided;
  std::vector<ElementIndex> elements;  ///< that move away, or too far for a step, where it failed for that
  std::vector<int> numbers;            ///< theirs, from 1, as tables have them
  int steps = 0;                       ///< accepted
  double time = 0;                     ///< reached
  std::string why_early = {};          ///< it finished before all steps were made; empty otherwise
  LedgerScope ledger_scope;
  StartReport start;
  std::vector<SceneReport> scenes = {};     ///< where there is more than one
  CrackNotes cracks;                        ///< as they grew
  FieldFrame field;                         ///< the end, within the elements
  std::optional<ForceBalance> forces = {};  ///< at the end, where the steps sum them
};

/// Unless asked otherwise, a run leaves at most this many frames: more are seldom looked at and fill the disk.
inline constexpr int kMostFrames = 100;
/// Steps from one frame to the next, unless asked otherwise: those of the analysis, or as many as `kMostFrames` asks.
int usual_frame_interval(const Problem& problem, const Settings& settings);

/// The steps of a run, one at a time. Views what it is given.
class StepLoop {
 public:
  StepLoop(const Scene& first, Stepper& stepper, int record_every, const Observer& observer);

  /// For a run that begins: the start is told as a step is.
  void tell_start();

  /// Makes one step. False where none is left, or could be made: the run is at its end, failed or stopped.
  bool step();

  /// Tells the last instant and gives the outcome.
  RunOutcome end();

 private:
  const State& state() const { return stepper_.state(); }
  bool is_framed() const { return state().step % record_every_ == 0 || stepper_.ends_scene(); }
  void fail(const StepFailure& failure);
  void tell(StepReport& report);
  void show();
  void keep_row();
  void tell_row();
  void keep_books();

  bool measures_;  ///< there were measured points in the first scene
  Stepper& stepper_;
  int record_every_;
  const Observer& observer_;
  RunOutcome outcome_;
};

/// Runs the scene. A frame is handed out at the start, every `record_every` steps and at the end, whatever
/// the end was. Where its context (base/context) is stopped in the middle of a step the run ends before it; throws
/// StopRequested where that is in the search for the start, before anything was told.
RunOutcome run(const Scene& scene, int record_every, const Observer& observer);

/// The rest of a run that began with the scene, as if it had not been left between two steps; what was told before is
/// not told again.
RunOutcome go_on(const Scene& scene, Stepper& stepper, int record_every, const Observer& observer);

}  // namespace keyblock
