// Computes Shi's automatic step: the time to move the allowed distance from a speed under an acceleration.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/step_size.hpp"

#include <algorithm>
#include <cmath>

#include "model/material_choices.hpp"

namespace keyblock {
namespace {

constexpr double kGrowth = 1.3;      // greatest ratio of a step to the last (legacy-formats 3.4)
constexpr double kStressFactor = 4;  // force of an initial stress on a block: this times stress times side (ibid.)

// Returns dt = (sqrt(v² + 2 a s) - v) / a in a form that loses no digits for a small acceleration.
double time_to_move(double distance, double speed, double acceleration) {
  return 2 * distance / (speed + std::sqrt(speed * speed + 2 * acceleration * distance));
}

// Returns the largest load component of any loading point at `time`.
double greatest_load(const Model& model, double time) {
  double load = 0;
  for (const CarriedPoint& p : model.loading_points) {
    const Point force = p.curve.at(time);
    load = std::max({load, std::abs(force.x), std::abs(force.y)});
  }
  return load;
}

double allowed_displacement(const Model& model, const Settings& settings) {
  return settings.allowed_displacement_ratio * model.scale;
}

}  // namespace

double first_step_size(const Model& model, const State& state, const Settings& settings, double start_speed) {
  if (settings.step_control == StepControl::constant) return settings.time_step;
  const BlockMaterial& material = model.block_materials.front();
  const double area = model.mean_area;
  double stress = 0;
  for (const BlockMaterial& m : model.block_materials)
    stress =
        std::max({stress, std::abs(m.initial_stress.xx), std::abs(m.initial_stress.yy), std::abs(m.initial_stress.xy)});
  const double mass = area * material.density;
  const double acceleration =
      std::max({material.unit_weight / material.density, kStressFactor * stress * std::sqrt(area) / mass,
                greatest_load(model, state.time) / mass});
  if (acceleration <= 0 && start_speed <= 0) return settings.time_step;
  return time_to_move(allowed_displacement(model, settings), start_speed, std::max(acceleration, 0.0));
}

double next_step_size(const Model& model, const State& state, const Settings& settings, const StepHistory& last) {
  if (settings.step_control == StepControl::constant)
    return settings.quirks.cut_step_stays ? last.dt : settings.time_step;
  const double mass = model.mean_area * model.block_materials.front().density;
  const double acceleration = std::max(last.penetration * last.penalty / mass, greatest_load(model, state.time) / mass);
  const double distance = allowed_displacement(model, settings);
  const double ratio = settings.quirks.step_rule_by_time ? state.time : last.displacement_ratio;
  const double speed = is_static(settings, model) ? 0 : ratio * distance / last.dt;
  if (acceleration <= 0 && speed <= 0) return std::min(settings.time_step, kGrowth * last.dt);
  return std::min(time_to_move(distance, speed, acceleration), kGrowth * last.dt);
}

}  // namespace keyblock
