// Combines gravity with the unit weight and density of each material.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/body_load.hpp"

#include <algorithm>

namespace keyblock {

namespace {

Eigen::Vector2d weight_by_rule(const BlockMaterial& material, const Settings& settings) {
  const Eigen::Vector2d gravity(settings.gravity.x, settings.gravity.y);
  if (settings.quirks.weight_of_first_material) return material.density * gravity;
  if (settings.file_gravity != 0) return material.unit_weight * (gravity / settings.file_gravity);
  return Eigen::Vector2d(0, -material.unit_weight) + material.density * gravity;
}

}  // namespace

Eigen::Vector2d weight_per_area(const BlockMaterial& material, const Settings& settings) {
  Eigen::Vector2d force = weight_by_rule(material, settings);
  if (material.horizontal_force != 0) force.x() += material.horizontal_force;
  return force;
}

Eigen::Vector2d body_acceleration_at(const Settings& settings, double time) {
  const Point sum = settings.body_acceleration.constant + settings.body_acceleration.curve.at(time);
  return {sum.x, sum.y};
}

bool has_body_acceleration(const Settings& settings) {
  const auto is_set = [](Point a) { return a.x != 0 || a.y != 0; };
  const auto& [constant, curve, file] = settings.body_acceleration;
  return is_set(constant) || std::ranges::any_of(curve.values, is_set);
}

}  // namespace keyblock
