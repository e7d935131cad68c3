// The loop over steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/run.hpp"

#include "run/record.hpp"

namespace keyblock {

RunOutcome run(const Scene& scene, int record_every, const Observer& observer) {
  Stepping stepping = start(scene);
  const State first = stepping.state;
  int last_framed = -1;
  const auto show = [&] {
    if (observer.on_frame && stepping.state.step != last_framed)
      observer.on_frame(frame_of(scene.model, stepping.state, first, scene.settings));
    last_framed = stepping.state.step;
  };
  RunOutcome outcome;
  const bool measures = !scene.model.measured_points.empty();
  const auto keep_row = [&] {
    const bool is_due =
        measures || stepping.state.step % record_every == 0 || stepping.state.step == scene.settings.step_count;
    if (observer.on_row && is_due) observer.on_row(history_row(scene.model, stepping.state, first));
  };
  show();
  keep_row();
  while (stepping.state.step < scene.settings.step_count) {
    if (observer.wants_stop && observer.wants_stop()) {
      outcome.end = RunEnd::stopped;
      break;
    }
    const auto made = advance(scene, stepping);
    if (const auto* failure = std::get_if<StepFailure>(&made)) {
      outcome.end = RunEnd::failed;
      outcome.reason = failure->reason;
      outcome.contacts = failure->contacts;
      break;
    }
    if (observer.on_step) observer.on_step(std::get<StepReport>(made));
    keep_row();
    if (stepping.state.step % record_every == 0) show();
  }
  show();
  outcome.steps = stepping.state.step;
  outcome.time = stepping.state.time;
  return outcome;
}

}  // namespace keyblock
