// ext-07: rest, spin and momentum after a million steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "tests/extremes/extreme.hpp"
#include "tests/extremes/extreme_scenes.hpp"

namespace keyblock::extremes {
namespace {

Extreme rest(const std::string& where, double slope, int steps) {
  Problem problem;
  problem.geometry = block_on_slope(slope);
  problem.analysis = plain_analysis(1e-3, steps);
  problem.analysis->joint_materials[0].friction_angle_deg = 30;
  const Run run = run_standard(problem);
  return {"ext-07",   fmt::format("{} steps at rest {}: drift", steps, where), 0, length(run.travel(1)), 1e-6,
          run.trouble};
}

// A slow spin: 1e-3 rad per step.
Extremes spin(int steps) {
  Problem problem;
  problem.geometry = scene_of_blocks({}, {rectangle({0, 0}, {1, 1})});
  problem.analysis = plain_analysis(1e-2, steps);
  problem.analysis->gravity = 0;
  problem.analysis->block_materials[0].initial_velocity = {0, 0, 0.1};
  const Run run = run_standard(problem);
  const ElementFrame last = run.block(0);
  return {{"ext-07", fmt::format("{} steps of spin: area", steps), 1.0, last.area, 1e-8, run.trouble},
          {"ext-07",
           fmt::format("{} steps of spin: angular momentum / start", steps),
           1,
           last.velocity.rotation / 0.1,
           1e-8,
           {}},
          {"ext-07",
           fmt::format("{} steps of spin: turn / start", steps),
           1,
           last.rotation / (0.1 * 1e-2 * steps),
           1e-8,
           {}}};
}

// Momentum of squares of a metre; a spin stretches their area, not their mass.
double momentum(const Frame& frame) {
  double sum = 0;
  for (const ElementFrame& e : frame.elements) sum += kDensity * e.velocity.x;
  return sum;
}

// Two blocks in free space, one overtaking the other, with friction between them.
Extreme two_bodies(int steps) {
  Problem problem;
  problem.geometry = scene_of_blocks({}, {rectangle({0, 0}, {1, 1}, 0), rectangle({1.05, 0.3}, {2.05, 1.3}, 1)});
  Analysis analysis = plain_analysis(1e-3, steps);
  analysis.gravity = 0;
  analysis.joint_materials[0].friction_angle_deg = 30;
  analysis.block_materials.push_back(analysis.block_materials[0]);
  analysis.block_materials[0].initial_velocity = {2, 0.1, 0};
  analysis.block_materials[1].initial_velocity = {1, 0, 0.05};
  problem.analysis = analysis;
  const Run run = run_standard(problem);
  return {"ext-07", fmt::format("{} steps of two bodies: momentum / start", steps),
          1,        momentum(run.last) / momentum(run.first),
          1e-9,     run.trouble};
}

}  // namespace

Extremes drift(Effort effort) {
  const int steps = effort == Effort::full ? 1'000'000 : 5'000;
  Extremes rows = spin(steps);
  rows.push_back(rest("on the flat", 0, steps));
  rows.push_back(rest("at 20 degrees", radians(20), steps));
  rows.push_back(two_bodies(steps));
  return rows;
}

}  // namespace keyblock::extremes
