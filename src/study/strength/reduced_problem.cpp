// Reduces materials one by one; see reduced_problem.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/strength/reduced_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "base/error.hpp"
#include "material/reduced_strength.hpp"

namespace keyblock::study {
namespace {

bool has_strength(const JointMaterial& joint) {
  return joint.friction_angle_deg > 0 || joint.has_strength();
}

// Returns the places in the list of materials that are not exempt.
template <class Material>
std::vector<std::size_t> not_exempt(const std::vector<Material>& materials, const std::set<int>& exempt) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < materials.size(); ++i)
    if (!exempt.contains(static_cast<int>(i))) places.push_back(i);
  return places;
}

}  // namespace

Problem with_reduced_strength(Problem problem, Reduced what, const Exempt& exempt, double factor) {
  if (!problem.analysis) return problem;
  std::vector<JointMaterial>& joints = problem.analysis->joint_materials;
  std::vector<BlockMaterial>& rocks = problem.analysis->block_materials;
  const std::vector<JointMaterial> joints_before = joints;
  const std::vector<BlockMaterial> rocks_before = rocks;
  if (factor != 1 && what != Reduced::rock)
    for (const std::size_t i : not_exempt(joints, exempt.joint_materials)) {
      JointMaterial& joint = joints[i];
      joint.friction_angle_deg = std::atan(joint.friction_tangent() / factor) * 180 / std::numbers::pi;
      joint.cohesion /= factor;
      joint.tensile_strength /= factor;
    }
  if (factor != 1 && what != Reduced::joints)
    for (const std::size_t i : not_exempt(rocks, exempt.block_materials))
      if (rocks[i].strength) rocks[i].strength = std::make_shared<const Strength>(reduced(*rocks[i].strength, factor));
  if (!exempt.regions.empty()) {
    joints.insert(joints.end(), joints_before.begin(), joints_before.end());
    rocks.insert(rocks.end(), rocks_before.begin(), rocks_before.end());
  }
  return problem;
}

void require_strength(const Problem& problem, Reduced what, const Exempt& exempt) {
  if (!problem.analysis) return;  // reported during preparation
  const Analysis& analysis = *problem.analysis;
  const auto refuse = [&](const char* expected) {
    throw InputError(analysis.place,
                     fmt::format("{}, found none{}", expected, exempt.is_empty() ? "" : " that is not exempt"));
  };
  const bool has_rock =
      std::ranges::any_of(not_exempt(analysis.block_materials, exempt.block_materials),
                          [&](std::size_t i) { return analysis.block_materials[i].strength != nullptr; });
  const bool has_joints = std::ranges::any_of(not_exempt(analysis.joint_materials, exempt.joint_materials),
                                              [&](std::size_t i) { return has_strength(analysis.joint_materials[i]); });
  if (what == Reduced::rock && !has_rock) refuse("expected a block material with a strength, which is to be reduced");
  if (what == Reduced::joints && !has_joints)
    refuse("expected a joint material with friction, cohesion or tensile strength, which is to be reduced");
  if (what == Reduced::both && !has_rock && !has_joints)
    refuse("expected a material with a strength, which is to be reduced");
}

bool flows_below_friction(const Problem& problem, Reduced what, const Exempt& exempt) {
  if (what == Reduced::joints || !problem.analysis) return false;
  const std::vector<BlockMaterial>& rocks = problem.analysis->block_materials;
  return std::ranges::any_of(not_exempt(rocks, exempt.block_materials), [&](std::size_t i) {
    return rocks[i].strength && keyblock::flows_below_friction(*rocks[i].strength);
  });
}

}  // namespace keyblock::study
