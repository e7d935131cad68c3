// ext-01: blocks a million times heavier than their neighbours, at rest and in impact.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "tests/extremes/extreme.hpp"
#include "tests/extremes/extreme_scenes.hpp"

namespace keyblock::extremes {
namespace {

constexpr double kLight = 2600;
constexpr double kHeavy = 2.6e9;
constexpr double kFewPasses = 6;
// Under 2.6e10 N/m a block of 5 GPa would be pressed to nothing; this one is strained by 5e-5.
constexpr double kUnyielding = 5e14;

// Moment equilibrium of the lower block: its stress times its width is the force on its top and half its own weight.
double force_on_lower(const Run& run, double lower_density) {
  return -run.block(1).stress.yy - lower_density * kGravity / 2;
}

Extremes rest(double lower, double upper) {
  Problem problem;
  Blocks blocks = column(2);
  blocks.blocks[1].material = 1;
  blocks.blocks[2].material = 2;
  problem.geometry = blocks;
  problem.analysis = plain_analysis(1e-3, 100);
  problem.analysis->block_materials.push_back(rock(lower, kUnyielding, kPoisson));
  problem.analysis->block_materials.push_back(rock(upper, kUnyielding, kPoisson));
  const Run run = run_standard(problem);
  const double weight = upper * kGravity;
  const std::string variant = fmt::format("{:g} on {:g} kg/m2: ", upper, lower);
  return {{"ext-01", variant + "force between them / weight above", 1, force_on_lower(run, lower) / weight, 1e-3,
           run.trouble},
          {"ext-01", variant + "most passes of a step", 0, static_cast<double>(run.most_passes), kFewPasses, {}}};
}

// Head on, in free space, with e = 1: v1' = -0.999998, v2' = 2e-6 (dda-13 case 3).
Extremes impact() {
  const double m1 = 2500;
  const double m2 = 2.5e9;
  Problem problem;
  problem.geometry = scene_of_blocks({}, {rectangle({0, 0}, {1, 1}, 0), rectangle({1.0123, 0}, {2.0123, 1}, 1)});
  Analysis analysis = plain_analysis(1e-3, 50);
  analysis.gravity = 0;
  analysis.block_materials = {rock(m1, kModulus, kPoisson), rock(m2, kModulus, kPoisson)};
  analysis.block_materials[0].initial_velocity = {1, 0, 0};
  problem.analysis = analysis;
  const Run run = run_standard(problem, {{"restitution", "1"}});
  const double v1 = run.block(0).velocity.x;
  const double v2 = run.block(1).velocity.x;
  const double expected1 = (m1 - m2) / (m1 + m2);
  const double expected2 = 2 * m1 / (m1 + m2);
  return {{"ext-01", "impact, v1 after", expected1, v1, 1e-3, run.trouble},
          {"ext-01", "impact, v2 after", expected2, v2, 1e-3 * expected2, {}},
          {"ext-01", "impact, momentum after / before", 1, (m1 * v1 + m2 * v2) / m1, 1e-10, {}},
          {"ext-01", "impact, most passes of a step", 0, static_cast<double>(run.most_passes), kFewPasses, {}}};
}

}  // namespace

Extremes mass_ratio(Effort) {
  Extremes rows;
  for (const Extremes& more : {rest(kLight, kHeavy), rest(kHeavy, kLight), impact()})
    rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

}  // namespace keyblock::extremes
