// Solves a scene in its first step; later steps of the scene keep that solution.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/linear_stepper.hpp"

#include <cmath>
#include <utility>

#include "model/continuum.hpp"

namespace keyblock {
namespace {

// Tolerance of sticking, as a fraction of the largest shear force that friction allows. Forces settle to less than
// this.
constexpr double kOfSliding = 1e-6;

ContactCondition condition_of(const FaceContact& contact, const JointMaterial& joint) {
  if (contact.normal_force == 0) return ContactCondition::open;
  const double limit = joint.friction_tangent() * contact.normal_force;
  return std::abs(contact.shear_force) < (1 - kOfSliding) * limit ? ContactCondition::stick : ContactCondition::slide;
}

}  // namespace

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

double LinearStepper::rotation_of(ElementIndex e, Point start) const {
  return solution_ ? solution_->rotation(e.value, start) : 0;
}

std::variant<StepReport, StepFailure> LinearStepper::advance() {
  const bool solves = !solution_;
  if (solves) {
    if (std::optional<StepFailure> unheld = unheld_pieces()) return *unheld;
    try {
      ContinuumSolution found = solve_static(continuum(), model().joint_materials);
      if (!found.faces_settled) return failure({"crack_faces_do_not_settle"});
      solution_ = std::move(found);
    } catch (const NotPositiveDefinite& error) {
      return failure({"not_positive_definite", {{}, {{"system", error.what()}}}});
    }
    put_places();
  }
  return end_step(solves ? 1 : 0, 0, solution_->solution.residual);
}

std::optional<ForceBalance> LinearStepper::forces() const {
  return solution_ ? std::optional(balance_of(continuum(), *solution_)) : std::nullopt;
}

ContactFrames LinearStepper::contacts() const {
  ContactFrames frames;
  if (!solution_) return frames;
  const int first = static_cast<int>(model().elements.size()) - solution_->basis.element_count();
  for (const FaceContact& contact : solution_->faces) {
    const FacePoint& point = contact.point;
    ContactFrame& frame = frames.emplace_back();
    frame.element = model().identities.of_element(first + point.element).number;
    frame.other = model().identities.of_element(first + point.other).number;
    frame.joint_material = point.joint_material;
    frame.condition = condition_of(contact, model().joint_material(point.joint_material));
    frame.position = point.at + solution_->displacement(point.element, point.at);
    frame.normal = point.normal;
    frame.gap = contact.gap;
    frame.slip = contact.slip;
    frame.normal_force = contact.normal_force;
    frame.shear_force = contact.shear_force;
    frame.edge = point.edge;
  }
  return frames;
}

// Only the step number and times need saving: all else in the state follows from the solution.
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
  if (continuum().faces_touch) describe_faces(archive);
}

void LinearStepper::describe_faces(Archive& archive) {
  const std::vector<FacePoint> points = face_points(continuum(), solution_->basis);
  const ContactRows rows = face_rows(solution_->basis, points);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < solution_->faces.size(); ++i)
    forces.segment<2>(static_cast<Eigen::Index>(2 * i)) << solution_->faces[i].normal_force,
        solution_->faces[i].shear_force;
  archive.values("face_forces", {forces.data(), static_cast<std::size_t>(forces.size())});
  if (archive.is_restoring()) solution_->faces = face_contacts(points, rows, forces, solution_->solution.x);
}

}  // namespace keyblock
