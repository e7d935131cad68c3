// The loop over steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/run.hpp"

#include "base/stop.hpp"
#include "run/record.hpp"
#include "run/steppers.hpp"

namespace keyblock {
namespace {

class Loop {
 public:
  Loop(const Scene& first, Stepper& stepper, int record_every, const Observer& observer)
      : measures_(!first.model.measured_points.empty()),
        stepper_(stepper),
        record_every_(record_every),
        observer_(observer) {}

  void tell_start() {
    if (observer_.on_state) observer_.on_state(stepper_);
    show();
    keep_row();
    keep_books();
  }

  RunOutcome go_on() {
    RunOutcome outcome;
    outcome.ledger_scope = stepper_.ledger_scope();
    outcome.start = stepper_.start_report();
    while (state().step < stepper_.settings().step_count && !stepper_.is_done()) {
      const bool stops = observer_.wants_stop && observer_.wants_stop();
      if (observer_.between_steps) observer_.between_steps(stepper_);
      if (stops) {
        outcome.end = RunEnd::stopped;
        break;
      }
      std::variant<StepReport, StepFailure> made;
      try {
        made = stepper_.advance();
      } catch (const StopRequested&) {
        if (observer_.wants_stop) observer_.wants_stop();  // so that it knows
        if (observer_.between_steps) observer_.between_steps(stepper_);
        outcome.end = RunEnd::stopped;
        break;
      }
      if (const auto* failure = std::get_if<StepFailure>(&made)) {
        outcome.end = RunEnd::failed;
        outcome.reason = failure->reason;
        outcome.contacts = failure->contacts;
        outcome.failure = failure->kind;
        outcome.elements = failure->elements;
        for (const ElementIndex e : failure->elements) outcome.numbers.push_back(stepper_.model().number_of(e));
        break;
      }
      auto& report = std::get<StepReport>(made);
      put_least_area(report, stepper_.model(), state(), stepper_.unloaded());
      if (observer_.on_step) observer_.on_step(report);
      keep_row();
      keep_books();
      if (observer_.on_state) observer_.on_state(stepper_);
      if (is_framed()) show();
    }
    if (!is_framed()) {
      show();
      if (!measures_ && state().step < stepper_.settings().step_count) tell_row();
    }
    if (outcome.end == RunEnd::finished && stepper_.is_done()) outcome.why_early = stepper_.why_done();
    outcome.steps = state().step;
    outcome.time = state().time;
    outcome.field = field_of(stepper_.model(), stepper_);
    outcome.forces = stepper_.forces();
    outcome.scenes = stepper_.scenes();
    outcome.cracks = stepper_.crack_notes();
    return outcome;
  }

 private:
  const State& state() const { return stepper_.state(); }
  bool is_framed() const { return state().step % record_every_ == 0 || stepper_.ends_scene(); }

  void show() {
    if (!observer_.on_frame) return;
    Frame frame = frame_of(stepper_.model(), state(), stepper_.unloaded(), stepper_.settings());
    put_point_stress(frame, stepper_.model(), stepper_);
    frame.reactions = reactions_of(stepper_);
    put_plastic(frame, stepper_);
    frame.tips = tips_of(stepper_, TipsOf::cracks_and_joints);
    frame.load_factor = stepper_.load_factor();
    if (observer_.on_field) observer_.on_field(field_of(stepper_.model(), stepper_));
    if (observer_.on_contacts) observer_.on_contacts(stepper_.contacts());
    observer_.on_frame(frame);
  }

  void keep_row() {
    const bool is_due = measures_ || is_framed() || state().step == stepper_.settings().step_count;
    if (is_due) tell_row();
  }

  void tell_row() {
    if (!observer_.on_row) return;
    HistoryRow row = history_row(stepper_.model(), state(), stepper_.unloaded(), measures_);
    if (measures_) put_point_stress(row, stepper_.model(), stepper_);
    row.reactions = reactions_of(stepper_);
    put_plastic(row, stepper_, measures_);
    row.tips = tips_of(stepper_, TipsOf::cracks);
    row.load_factor = stepper_.load_factor();
    observer_.on_row(row);
  }

  void keep_books() {
    if (observer_.on_ledger && stepper_.settings().ledger == Bookkeeping::on) observer_.on_ledger(stepper_.ledger());
  }

  bool measures_;  ///< there were measured points in the first scene
  Stepper& stepper_;
  int record_every_;
  const Observer& observer_;
};

}  // namespace

RunOutcome run(const Scene& scene, int record_every, const Observer& observer) {
  const std::unique_ptr<Stepper> stepper = stepper_for(scene);
  Loop loop(scene, *stepper, record_every, observer);
  loop.tell_start();
  return loop.go_on();
}

RunOutcome go_on(const Scene& scene, Stepper& stepper, int record_every, const Observer& observer) {
  return Loop(scene, stepper, record_every, observer).go_on();
}

}  // namespace keyblock
