// Maps contacts back to the undeformed faces on which they act.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/growth/solution_of.hpp"

#include <unordered_map>

#include "model/continuum.hpp"

namespace keyblock {
namespace {

// Iterations of X = x - u(X), which contracts if strains are small.
constexpr int kRounds = 3;

Point sum_at(const ElementShape& shape, const Eigen::VectorXd& d, Point start) {
  const Eigen::RowVectorXd n = shape.values(start);
  Eigen::Vector2d u = Eigen::Vector2d::Zero();
  for (int a = 0; a < shape.function_count(); ++a)
    u += n(a) * d.segment<2>(2 * shape.functions[static_cast<std::size_t>(a)]);
  return {u.x(), u.y()};
}

Point undeformed(const CoverDisplacement& moved, int element, Point x) {
  const ElementShape shape = moved.basis.shape(element);
  Point start = x;
  for (int round = 0; round < kRounds; ++round) start = x - sum_at(shape, moved.d, start);
  return start;
}

/// Maps the numbers used in frames to elements of the manifold.
std::unordered_map<int, int> elements_by_number(const Model& model) {
  std::unordered_map<int, int> elements;
  const int count = static_cast<int>(model.continuum->manifold.elements.size());
  const int first = static_cast<int>(model.elements.size()) - count;
  for (int e = 0; e < count; ++e) elements.emplace(model.identities.of_element(first + e).number, e);
  return elements;
}

std::vector<FaceForce> face_forces(const Stepper& stepper, const CoverDisplacement& moved) {
  std::vector<FaceForce> forces;
  const ContactFrames contacts = stepper.contacts();
  if (contacts.empty()) return forces;
  const std::unordered_map<int, int> elements = elements_by_number(stepper.model());
  const auto element_of = [&](int number) {
    const auto found = elements.find(number);
    return found == elements.end() ? -1 : found->second;
  };
  const auto add = [&](int number, int other, Point at, Point force) {
    if (const int e = element_of(number); e >= 0)
      forces.push_back({e, undeformed(moved, e, at), force, element_of(other)});
  };
  for (const ContactFrame& contact : contacts) {
    if (contact.normal_force == 0 && contact.shear_force == 0) continue;
    add(contact.element, contact.other, contact.position, contact.force());
    add(contact.other, contact.element, contact.position, -1.0 * contact.force());
  }
  return forces;
}

}  // namespace

Point displacement_at(const CoverDisplacement& moved, int element, Point start) {
  return sum_at(moved.basis.shape(element), moved.d, start);
}

std::optional<CoverSolution> solution_of(const Stepper& stepper) {
  const std::optional<CoverDisplacement> moved = stepper.on_covers();
  if (!moved) return std::nullopt;
  return CoverSolution{*stepper.model().continuum,  moved->basis, moved->d, moved->is_large, moved->acceleration,
                       face_forces(stepper, *moved)};
}

}  // namespace keyblock
