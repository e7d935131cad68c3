// Materials one by one; see reduced_problem.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/strength/reduced_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "base/error.hpp"
#include "material/reduced_strength.hpp"

namespace keyblock::study {
namespace {

constexpr std::array<const char*, 3> kNames{"joints", "rock", "both"};

bool has_strength(const JointMaterial& joint) {
  return joint.friction_angle_deg > 0 || joint.cohesion > 0 || joint.tensile_strength > 0;
}

}  // namespace

std::string name_of(Reduced what) {
  return kNames.at(static_cast<std::size_t>(what));
}

Reduced reduced_of(const std::string& name) {
  const auto* const found = std::ranges::find(kNames, name);
  if (found == kNames.end())
    throw std::invalid_argument(fmt::format("expected joints, rock or both, found \"{}\"", name));
  return static_cast<Reduced>(found - kNames.begin());
}

Problem with_reduced_strength(Problem problem, Reduced what, double factor) {
  if (!problem.analysis || factor == 1) return problem;
  if (what != Reduced::rock)
    for (JointMaterial& joint : problem.analysis->joint_materials) {
      joint.friction_angle_deg = std::atan(joint.friction_tangent() / factor) * 180 / std::numbers::pi;
      joint.cohesion /= factor;
      joint.tensile_strength /= factor;
    }
  if (what != Reduced::joints)
    for (BlockMaterial& rock : problem.analysis->block_materials)
      if (rock.strength) rock.strength = std::make_shared<const Strength>(reduced(*rock.strength, factor));
  return problem;
}

void require_strength(const Problem& problem, Reduced what) {
  if (!problem.analysis) return;  // said when it is prepared
  const Analysis& analysis = *problem.analysis;
  const auto refuse = [&](const char* expected) { throw InputError(analysis.place, expected); };
  const bool has_rock =
      std::ranges::any_of(analysis.block_materials, [](const BlockMaterial& rock) { return rock.strength != nullptr; });
  const bool has_joints = std::ranges::any_of(analysis.joint_materials, has_strength);
  if (what == Reduced::rock && !has_rock)
    refuse("expected a block material with a strength, which is to be reduced, found none");
  if (what == Reduced::joints && !has_joints)
    refuse("expected a joint material with friction, cohesion or tensile strength, which is to be reduced, found none");
  if (what == Reduced::both && !has_rock && !has_joints)
    refuse("expected a material with a strength, which is to be reduced, found none");
}

bool flows_below_friction(const Problem& problem, Reduced what) {
  return what != Reduced::joints && problem.analysis &&
         std::ranges::any_of(problem.analysis->block_materials, [](const BlockMaterial& rock) {
           return rock.strength && keyblock::flows_below_friction(*rock.strength);
         });
}

}  // namespace keyblock::study
