// The loop over steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/run.hpp"

#include "run/record.hpp"
#include "step/stepper.hpp"

namespace keyblock {

RunOutcome run(const Scene& scene, int record_every, const Observer& observer) {
  const std::unique_ptr<Stepper> stepper = stepper_for(scene);
  const State& first = stepper->unloaded();
  int last_framed = -1;
  const auto show = [&] {
    if (observer.on_frame && stepper->state().step != last_framed)
      observer.on_frame(frame_of(scene.model, stepper->state(), first, scene.settings));
    last_framed = stepper->state().step;
  };
  RunOutcome outcome;
  const bool measures = !scene.model.measured_points.empty();
  const auto keep_row = [&] {
    const bool is_due =
        measures || stepper->state().step % record_every == 0 || stepper->state().step == scene.settings.step_count;
    if (observer.on_row && is_due) observer.on_row(history_row(scene.model, stepper->state(), first));
  };
  outcome.ledger_scope = stepper->ledger_scope();
  outcome.start = stepper->start_report();
  const auto keep_books = [&] {
    if (observer.on_ledger && scene.settings.ledger == Bookkeeping::on) observer.on_ledger(stepper->ledger());
  };
  show();
  keep_row();
  keep_books();
  while (stepper->state().step < scene.settings.step_count) {
    if (observer.wants_stop && observer.wants_stop()) {
      outcome.end = RunEnd::stopped;
      break;
    }
    const auto made = stepper->advance();
    if (const auto* failure = std::get_if<StepFailure>(&made)) {
      outcome.end = RunEnd::failed;
      outcome.reason = failure->reason;
      outcome.contacts = failure->contacts;
      break;
    }
    if (observer.on_step) observer.on_step(std::get<StepReport>(made));
    keep_row();
    keep_books();
    if (stepper->state().step % record_every == 0) show();
  }
  show();
  outcome.steps = stepper->state().step;
  outcome.time = stepper->state().time;
  return outcome;
}

}  // namespace keyblock
