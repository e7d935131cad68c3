// A block on a base that is driven to and fro sticks, or slides as a sliding block does (Newmark 1965).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/staged_runs.hpp"

namespace keyblock::shaken_base_test {
namespace {

using support::column;
using support::kGravity;
using support::Told;
using support::told_of;

constexpr double kTime = 2, kRate = 4 * std::numbers::pi;  // 2 Hz

/// The base moves by A (1 - cos ω t).
struct Shaking {
  double amplitude = 0;
  double friction_deg = 0;

  double place(double t) const { return amplitude * (1 - std::cos(kRate * t)); }
  double acceleration(double t) const { return amplitude * kRate * kRate * std::cos(kRate * t); }

  /// Displacement of the block on the base, by steps of 10 μs. The block starts at rest, as the base does.
  double slip() const {
    constexpr double kStep = 1e-5;
    const double limit = kGravity * std::tan(friction_deg * std::numbers::pi / 180);
    double velocity = 0, way = 0;
    for (double t = kStep / 2; t < kTime; t += kStep) {
      const double asked = -acceleration(t);
      if (velocity == 0 && std::abs(asked) <= limit) continue;
      const double friction = velocity != 0 ? -std::copysign(limit, velocity) : -std::copysign(limit, asked);
      const double next = velocity + kStep * (asked + friction);
      const double end = velocity * next < 0 ? 0 : next;
      way += kStep * (velocity + end) / 2;
      velocity = end;
    }
    return way;
  }

  Told run(double dt) const {
    Problem problem = column(1, dt);
    problem.analysis->step_count = static_cast<int>(std::lround(kTime / dt));
    problem.analysis->joint_materials[0].friction_angle_deg = friction_deg;
    TimeCurve motion;
    for (double t = 0; t <= kTime + 0.1; t += 1e-3) {
      motion.times.push_back(t);
      motion.values.push_back({place(t), 0});
    }
    problem.analysis->fixed_point_motions = {motion, motion};
    return told_of(problem);
  }
};

double slip_of(const Told& told) {
  return told.at_end(2).displacement.x - told.at_end(1).displacement.x;
}

}  // namespace

// By the lag of a mean velocity it slid by -25 to +31 % at 50 steps a period.
TEST(ShakenBase, a_block_slides_as_newmark_says) {
  for (const double friction : {20.0, 30.0}) {
    const Shaking shaking{0.05, friction};
    const double slip = shaking.slip();
    ASSERT_GT(std::abs(slip), 5e-3);
    EXPECT_NEAR(slip_of(shaking.run(0.01)), slip, 0.05 * std::abs(slip)) << friction;
    EXPECT_NEAR(slip_of(shaking.run(0.0025)), slip, 0.05 * std::abs(slip)) << friction;
  }
}

// The limit is that of a run that is trusted, energy_limit. By the lag, 10 s at 0.2 g made 1.2 of the largest energy.
TEST(ShakenBase, a_block_that_sticks_gains_no_energy) {
  const Told told = Shaking{0.01, 30}.run(0.01);
  double largest = 0;
  for (const LedgerRow& row : told.ledger.rows) largest = std::max(largest, row.stored.kinetic);
  EXPECT_LT(std::abs(told.ledger.rows.back().flow.creep), 1e-2 * largest);
  EXPECT_NEAR(slip_of(told), 0, 1e-4);
}

}  // namespace keyblock::shaken_base_test
