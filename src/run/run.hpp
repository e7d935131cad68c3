// Runs a problem from its first state to its last: makes steps in sequence and passes each to an observer.
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

/// Callbacks of a run. Any may be empty.
struct Observer {
  std::function<void(Frame)> on_frame;
  std::function<void(const StepReport&)> on_step;
  /// At the start and after every step. Without measured points the rows hold all centroids, and come with the frames.
  std::function<void(const HistoryRow&)> on_row;
  std::function<void(const LedgerRow&)> on_ledger;  ///< at the start and after every step, if the settings request it
  /// Before every step, and when the run is stopped. The data reported so far and this stepper suffice to continue.
  std::function<void(Stepper&)> between_steps = {};
  /// Before each frame: field values within the elements at the same instant.
  std::function<void(FieldFrame)> on_field = {};
  std::function<void(const ContactFrames&)> on_contacts = {};  ///< before each frame
  std::function<void(const Stepper&)> on_state = {};           ///< at the start and after every step
};

enum class RunEnd { finished, failed, stopped };

struct RunOutcome {
  RunEnd end = RunEnd::finished;
  std::string reason;                 ///< reason of a failure; empty otherwise
  Finding cause;                      ///< the values behind it; empty if the failure has none
  std::vector<std::size_t> contacts;  ///< contacts (from 0) that did not settle
  FailureKind failure = FailureKind::undecided;
  std::vector<ElementIndex> elements;  ///< that move away, or too far for a step, if that is the failure
  std::vector<int> numbers;            ///< their numbers from 1, as in tables
  int steps = 0;                       ///< accepted
  double time = 0;                     ///< reached
  std::string why_early = {};          ///< reason of an end before all steps; empty otherwise
  LedgerScope ledger_scope;
  StartReport start;
  std::vector<SceneReport> scenes = {};     ///< if there are several
  CrackNotes cracks;                        ///< notes on their growth
  FieldFrame field;                         ///< at the end, within the elements
  std::optional<ForceBalance> forces = {};  ///< at the end, if the steps compute them
};

/// Largest number of frames of a run, unless set otherwise: more are rarely viewed and fill the disk.
inline constexpr int kMostFrames = 100;
/// Returns the steps between frames, unless set otherwise: those of the analysis, or as many as `kMostFrames` requires.
int usual_frame_interval(const Problem& problem, const Settings& settings);

/// Makes the steps of a run one at a time. Keeps references to its arguments.
class StepLoop {
 public:
  StepLoop(const Scene& first, Stepper& stepper, int record_every, const Observer& observer);

  /// Reports the start of a new run like a step.
  void tell_start();

  /// Makes one step. Returns false at the end of the run, after a failure or after a stop.
  bool step();

  /// Reports the last instant and returns the outcome.
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

/// Runs the scene. Frames are made at the start, every `record_every` steps and at any end. If its context
/// (base/context) is stopped within a step, the run ends before that step. Throws StopRequested if that happens in the
/// search for the start, before any report.
RunOutcome run(const Scene& scene, int record_every, const Observer& observer);

/// Continues a run of the scene as if it had not been interrupted between two steps; earlier reports are not repeated.
RunOutcome go_on(const Scene& scene, Stepper& stepper, int record_every, const Observer& observer);

}  // namespace keyblock
