// Prepares a case for its first step by `planned`.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/folder/outputs_asked.hpp"
#include "library/parts.hpp"

namespace keyblock::api {
inline namespace v1 {

Plan::Plan(const Case& of, const Choices& choices, const Context& context) {
  data_ = guarded([&] {
    const Under under(context.state().context);
    Problem problem = of.data().open.input.problem;
    OutputOptions outputs;
    outputs.histories = choices.histories;
    problem.outputs = outputs_asked(problem.outputs, outputs);
    return std::make_shared<const Data>(Data{of, planned(asked_under(of, choices), problem)});
  });
}

const std::string& Plan::profile() const {
  return data_->planned.profile.name;
}

const std::string& Plan::why_profile() const {
  return data_->planned.profile.why;
}

std::vector<std::pair<std::string, std::string>> Plan::settings() const {
  return public_settings(data_->planned.prepared);
}

std::vector<Warning> Plan::warnings() const {
  return public_warnings(joined(data_->of.data().open.input.warnings, data_->planned.warnings));
}

int Plan::unknowns() const {
  return data_->planned.prepared.requirements.unknowns;
}

int Plan::blocks() const {
  return static_cast<int>(data_->planned.prepared.scene.model.elements.size());
}

int Plan::steps() const {
  return data_->planned.prepared.scene.settings.step_count;
}

std::vector<double> Plan::step_times() const {
  std::vector<double> times{0};
  for (const Scene* scene : scenes_of(data_->planned.prepared.scene)) {
    const double begin = times.back();
    const int steps = scene->end.steps > 0 ? scene->end.steps : scene->settings.step_count;
    for (int i = 1; i <= steps; ++i) times.push_back(begin + i * scene->settings.time_step);
  }
  return times;
}

}  // namespace v1
}  // namespace keyblock::api
