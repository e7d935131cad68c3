// Scales a motion by the gravity of the materials.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/ground_motion.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentences/sentences.hpp"

namespace keyblock {
namespace {

constexpr double kSameGravity = 1e-3;  // relative: files round weights and masses to a few digits

double gravity_of(const BlockMaterial& material) {
  return material.unit_weight / material.density;
}

bool differs(double a, double b) {
  return std::abs(a - b) > kSameGravity * std::max(std::abs(a), std::abs(b));
}

}  // namespace

Warnings apply_motion(Analysis& analysis, const TimeCurve& motion) {
  if (!analysis.body_acceleration.times.empty())
    throw InputError(motion.place,
                     "expected one motion of the blocks, found a second: the analysis has a body acceleration");
  const std::vector<BlockMaterial>& materials = analysis.block_materials;
  const bool is_stated = analysis.gravity.value_or(0) != 0;
  const double of_first = materials.empty() ? 0 : gravity_of(materials.front());
  const double gravity = is_stated ? *analysis.gravity : of_first;
  if (gravity == 0)
    throw InputError(motion.place,
                     "expected weights of blocks, to know the gravity that the motion is a multiple of; found none");
  analysis.body_acceleration = motion;
  for (Point& value : analysis.body_acceleration.values) value = gravity * value;
  Warnings warnings{warning_of({"motion_applied", {{{"gravity", gravity}}}}, motion.place)};
  const auto is_other = [&](const BlockMaterial& material) { return differs(gravity_of(material), gravity); };
  if (const auto count = std::ranges::count_if(materials, is_other); !is_stated && count > 0)
    warnings.push_back(
        warning_of({"motion_of_one_gravity", {{{"count", count}, {"materials", materials.size()}}}}, motion.place));
  return warnings;
}

}  // namespace keyblock
