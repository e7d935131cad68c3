// A scene is solved in its first step; the steps after it find the same.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/linear_stepper.hpp"

#include <utility>

#include "model/continuum.hpp"

namespace keyblock {

LinearStepper::LinearStepper(Scene scene) : StaticStepper(std::move(scene)) {
  begin_unloaded();
}

LinearStepper::LinearStepper(Scene scene, Archive& saved) : LinearStepper(std::move(scene)) {
  describe(saved);
}

std::unique_ptr<SceneStepper> LinearStepper::in_next(const SceneChange& change) const {
  auto next = std::make_unique<LinearStepper>(change.scene);
  next->continue_from(*this);
  return next;
}

Stress LinearStepper::stress_at(ElementIndex e, Point start) const {
  return solution_ ? keyblock::stress_at(continuum(), *solution_, e.value, start)
                   : continuum().initial_stress_at(e.value, start);
}

Point LinearStepper::place_of(ElementIndex e, Point start) const {
  return solution_ ? start + solution_->displacement(e.value, start) : start;
}

std::variant<StepReport, StepFailure> LinearStepper::advance() {
  const bool solves = !solution_;
  if (solves) {
    if (std::optional<StepFailure> unheld = unheld_pieces()) return *unheld;
    try {
      solution_ = solve_static(continuum());
    } catch (const NotPositiveDefinite& error) {
      return failure(error.what());
    }
    put_places();
  }
  return end_step(solves ? 1 : 0, 0, solution_->solution.residual);
}

std::optional<ForceBalance> LinearStepper::forces() const {
  return solution_ ? std::optional(balance_of(continuum(), *solution_)) : std::nullopt;
}

// The state is that of the solution, but for its step and times.
void LinearStepper::describe(Archive& archive) {
  bool is_solved = solution_.has_value();
  archive.value("is_solved", is_solved);
  if (is_solved) describe_solution(archive);
  if (archive.is_restoring()) put_places();
  describe_time(archive);
}

void LinearStepper::describe_solution(Archive& archive) {
  if (archive.is_restoring()) solution_.emplace(basis_of(continuum()), SparseSolution());
  SparseSolution& found = solution_->solution;
  if (archive.is_restoring()) found.x.setZero(2 * solution_->basis.function_count());
  archive.values("unknowns", {found.x.data(), static_cast<std::size_t>(found.x.size())});
  archive.value("residual", found.residual);
}

}  // namespace keyblock
