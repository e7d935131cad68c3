// ext-03: contact springs from a thousandth of the modulus to a million times it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>

#include "tests/extremes/extreme.hpp"
#include "tests/extremes/extreme_scenes.hpp"

namespace keyblock::extremes {
namespace {

constexpr std::array<double, 10> kRatios{1e-3, 1e-2, 1e-1, 1, 10, 1e2, 1e3, 1e4, 1e5, 1e6};
// Beyond this ratio a warning or 5 % is required, below it the formula.
constexpr double kUsual = 1e4;

std::vector<Override> springs(double stiffness) {
  return {{"enforcement", "penalty"}, {"contact_penalty", fmt::format("{}", stiffness)}};
}

double share(double ratio) {
  return ratio > kUsual ? 0.05 : 0.01;
}

// Top settlement ρ g H²/(2E) + Σ W_k/(2p) of ten blocks without lateral strain (dda-30).
Extreme settlement(double ratio) {
  constexpr int kCount = 10;
  Problem problem;
  problem.geometry = column(kCount);
  problem.analysis = plain_analysis(1e-3, 50);
  problem.analysis->block_materials = {rock(kDensity, kModulus, 0)};
  const Run run = run_standard(problem, springs(ratio * kModulus));
  const double weight = kDensity * kGravity;
  const double passed_on = weight * kCount * (kCount + 1) / 2;
  const double expected = weight * kCount * kCount / (2 * kModulus) + passed_on / (2 * ratio * kModulus);
  return {"ext-03",
          fmt::format("p/E {:g}: settlement of ten blocks", ratio),
          expected,
          -run.measured(0).y,
          share(ratio) * expected,
          run.trouble};
}

// A block on two springs settles by W/(2p).
Extreme penetration(double ratio) {
  Problem problem;
  Blocks blocks = column(1);
  blocks.measured_points = {{{0, 0}, 1, {}}};
  problem.geometry = blocks;
  problem.analysis = plain_analysis(1e-3, 50);
  problem.analysis->block_materials = {rock(kDensity, kModulus, 0)};
  const Run run = run_standard(problem, springs(ratio * kModulus));
  const double expected = kDensity * kGravity / (2 * ratio * kModulus);
  return {"ext-03",
          fmt::format("p/E {:g}: penetration of one block", ratio),
          expected,
          -run.measured(0).y,
          share(ratio) * expected,
          run.trouble};
}

// The initial state stretches the springs already: travel is counted from there.
Extreme sliding(double ratio) {
  const double time = 0.5;
  Problem problem;
  problem.geometry = block_on_slope(radians(30));
  problem.analysis = plain_analysis(1e-3, 500);
  problem.analysis->joint_materials[0].friction_angle_deg = 15;
  const Run run = run_standard(problem, springs(ratio * kModulus));
  const double expected = slide(radians(30), radians(15), time);
  return {"ext-03",
          fmt::format("p/E {:g}: slide in 0.5 s", ratio),
          expected,
          length(run.travel(1)),
          share(ratio) * expected,
          run.trouble};
}

}  // namespace

Extremes penalty_sweep(Effort) {
  Extremes rows;
  for (const double ratio : kRatios) {
    rows.push_back(settlement(ratio));
    rows.push_back(penetration(ratio));
    rows.push_back(sliding(ratio));
  }
  return rows;
}

}  // namespace keyblock::extremes
