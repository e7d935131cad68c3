// Changes from one scene to the next at the beginning of the following step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/stages/chain_stepper.hpp"

#include <algorithm>
#include <utility>

#include "result/describe.hpp"
#include "step/scene_steppers.hpp"

namespace keyblock {

ChainStepper::ChainStepper(Scene first) : scene_(std::move(first)) {
  now_ = scene_stepper(scene_);
  scope_ = now_->ledger_scope();
  begin(scene_);
}

ChainStepper::ChainStepper(Scene first, Archive& saved) : scene_(std::move(first)) {
  scope_ = ledger_scope_of(scene_);
  describe_chain(saved);
  for (std::size_t i = 1; i < reports_.size(); ++i) {
    if (!scene_.next) saved.refuse("scenes", "expected no more scenes than the files have, found more");
    const auto next = scene_.next;
    scene_ = next->scene;
  }
  saved.group("scene", [&] { now_ = restored_scene_stepper(scene_, saved); });
}

void ChainStepper::describe_chain(Archive& archive) {
  archive.value("ends_scene", ends_scene_);
  archive.list("scenes", reports_, [&](SceneReport& report) {
    archive.value("name", report.name);
    archive.value("first_step", report.first_step);
    archive.value("last_step", report.last_step);
    archive.value("end_time", report.end_time);
    archive.value("asks_equilibrium", report.asks_equilibrium);
    archive.value("is_balanced", report.is_balanced);
    bool has_forces = report.forces.has_value();
    archive.value("has_forces", has_forces);
    if (has_forces) describe(archive, report.forces ? *report.forces : report.forces.emplace());
  });
}

void ChainStepper::save(Archive& archive) {
  describe_chain(archive);
  archive.group("scene", [&] { now_->save(archive); });
}

void ChainStepper::begin(const Scene& scene) {
  const State& state = now_->state();
  reports_.push_back({scene.end.name, state.step, state.step, state.time, scene.end.equilibrium.has_value(), false});
  ends_scene_ = false;
}

// `prepare` has already checked for every possible exception.
void ChainStepper::follow() {
  const std::shared_ptr<const SceneChange> next = scene_.next;
  now_ = now_->in_next(*next);
  scene_ = next->scene;
  begin(scene_);
}

std::variant<StepReport, StepFailure> ChainStepper::advance() {
  if (ends_scene_ && scene_.next) follow();
  std::variant<StepReport, StepFailure> made = now_->advance();
  if (std::holds_alternative<StepFailure>(made)) return made;
  SceneReport& report = reports_.back();
  report.last_step = now_->state().step;
  report.end_time = now_->state().time;
  report.is_balanced = scene_.end.equilibrium && now_->is_at_rest(*scene_.end.equilibrium) &&
                       last_change_of_loads(scene_) <= report.end_time;
  const int steps = report.last_step - report.first_step;
  ends_scene_ = report.is_balanced || (scene_.end.steps > 0 && steps >= scene_.end.steps);
  if (ends_scene_) report.forces = now_->forces();
  return made;
}

LedgerScope ChainStepper::ledger_scope() const {
  LedgerScope scope = now_->ledger_scope();
  scope.has_flows = scope_.has_flows;
  scope.has_supports = scope.has_supports || scope_.has_supports;
  scope.has_changes = true;
  scope.may_yield = scope.may_yield || scope_.may_yield;
  scope.centre = scope_.centre;
  return scope;
}

}  // namespace keyblock
