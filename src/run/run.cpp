// Implements the loop over steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/run.hpp"

#include <algorithm>
#include <utility>

#include "base/context.hpp"
#include "run/record.hpp"
#include "run/steppers.hpp"

namespace keyblock {

int usual_frame_interval(const Problem& problem, const Settings& settings) {
  const int thinned = (settings.step_count + kMostFrames - 1) / kMostFrames;
  return std::max({1, thinned, problem.analysis->save_interval.value_or(1)});
}

StepLoop::StepLoop(const Scene& first, Stepper& stepper, int record_every, const Observer& observer)
    : measures_(!first.model.measured_points.empty()),
      stepper_(stepper),
      record_every_(record_every),
      observer_(observer) {
  outcome_.ledger_scope = stepper_.ledger_scope();
  outcome_.start = stepper_.start_report();
}

void StepLoop::tell_start() {
  if (observer_.on_state) observer_.on_state(stepper_);
  show();
  keep_row();
  keep_books();
}

bool StepLoop::step() {
  if (outcome_.end != RunEnd::finished || state().step >= stepper_.settings().step_count || stepper_.is_done())
    return false;
  const bool stops = context().is_stopped();
  if (observer_.between_steps) observer_.between_steps(stepper_);
  if (stops) {
    outcome_.end = RunEnd::stopped;
    return false;
  }
  std::variant<StepReport, StepFailure> made;
  try {
    made = stepper_.advance();
  } catch (const StopRequested&) {
    if (observer_.between_steps) observer_.between_steps(stepper_);
    outcome_.end = RunEnd::stopped;
    return false;
  }
  if (const auto* failure = std::get_if<StepFailure>(&made)) {
    fail(*failure);
    return false;
  }
  tell(std::get<StepReport>(made));
  return true;
}

void StepLoop::fail(const StepFailure& failure) {
  outcome_.end = RunEnd::failed;
  outcome_.reason = failure.reason;
  outcome_.cause = failure.cause;
  outcome_.contacts = failure.contacts;
  outcome_.failure = failure.kind;
  outcome_.elements = failure.elements;
  for (const ElementIndex e : failure.elements) outcome_.numbers.push_back(stepper_.model().number_of(e));
}

void StepLoop::tell(StepReport& report) {
  put_least_area(report, stepper_.model(), state(), stepper_.unloaded());
  if (observer_.on_step) observer_.on_step(report);
  keep_row();
  keep_books();
  if (observer_.on_state) observer_.on_state(stepper_);
  if (is_framed()) show();
}

RunOutcome StepLoop::end() {
  if (!is_framed()) {
    show();
    if (!measures_ && state().step < stepper_.settings().step_count) tell_row();
  }
  if (outcome_.end == RunEnd::finished && stepper_.is_done()) outcome_.why_early = stepper_.why_done();
  outcome_.steps = state().step;
  outcome_.time = state().time;
  outcome_.field = field_of(stepper_.model(), stepper_);
  outcome_.forces = stepper_.forces();
  outcome_.scenes = stepper_.scenes();
  outcome_.cracks = stepper_.crack_notes();
  return std::move(outcome_);
}

void StepLoop::show() {
  if (!observer_.on_frame) return;
  if (observer_.on_field) observer_.on_field(field_of(stepper_.model(), stepper_));
  if (observer_.on_contacts) observer_.on_contacts(stepper_.contacts());
  observer_.on_frame(frame_now(stepper_));
}

void StepLoop::keep_row() {
  const bool is_due = measures_ || is_framed() || state().step == stepper_.settings().step_count;
  if (is_due) tell_row();
}

void StepLoop::tell_row() {
  if (!observer_.on_row) return;
  HistoryRow row = history_row(stepper_.model(), state(), stepper_.unloaded(), measures_);
  if (measures_) put_point_stress(row, stepper_.model(), stepper_);
  row.reactions = reactions_of(stepper_);
  put_plastic(row, stepper_, measures_);
  row.tips = tips_of(stepper_, TipsOf::cracks);
  row.load_factor = stepper_.load_factor();
  observer_.on_row(row);
}

void StepLoop::keep_books() {
  if (observer_.on_ledger && stepper_.settings().ledger == Bookkeeping::on) observer_.on_ledger(stepper_.ledger());
}

RunOutcome run(const Scene& scene, int record_every, const Observer& observer) {
  const std::unique_ptr<Stepper> stepper = stepper_for(scene);
  StepLoop loop(scene, *stepper, record_every, observer);
  loop.tell_start();
  while (loop.step()) {
  }
  return loop.end();
}

RunOutcome go_on(const Scene& scene, Stepper& stepper, int record_every, const Observer& observer) {
  StepLoop loop(scene, stepper, record_every, observer);
  while (loop.step()) {
  }
  return loop.end();
}

}  // namespace keyblock
