// Walls that fall by less than a step, or little more: their springs must not drive blocks in and lift them again.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/support/standard_scenes.hpp"

namespace keyblock::clean_up_test {
namespace {

using support::plain_analysis;
using support::rectangle;
using support::standard_scene_of;
using support::standard_settings;

constexpr int kColumns = 3;
constexpr int kCourses = 4;

// Bricks of 1 m by 0.5 m in running bond, drawn in contact with each other and `gap` above a fixed floor.
Scene wall(double gap, double dt, double youngs_modulus, BlockBasis basis) {
  Blocks blocks;
  blocks.blocks = {rectangle({-5, -1}, {10, 0})};
  blocks.fixed_points = {{{-4, -0.5}, 0, {}}, {{9, -0.5}, 0, {}}};
  for (int course = 0; course < kCourses; ++course)
    for (int column = 0; column < kColumns; ++column) {
      const double x = column + (course % 2) * 0.25;
      const double y = gap + course * 0.5;
      blocks.blocks.push_back(rectangle({x, y}, {x + 1, y + 0.5}));
    }
  Analysis analysis = plain_analysis(dt, 1);
  analysis.penalty_factor = 50;
  analysis.block_materials[0].youngs_modulus = youngs_modulus;
  analysis.joint_materials[0].friction_angle_deg = 20;
  Settings settings = standard_settings(analysis);
  settings.basis = basis;
  settings.standard.enforcement = Enforcement::penalty;
  settings.ledger = Bookkeeping::on;
  return standard_scene_of(blocks, analysis, settings);
}

double energy(const LedgerRow& row) {
  return row.stored.kinetic + row.stored.strain + row.stored.gravity + row.stored.contact;
}

}  // namespace

TEST(CleanUp, a_wall_that_falls_through_a_small_gap_makes_no_energy) {
  for (const BlockBasis basis : {BlockBasis::rigid, BlockBasis::affine})
    for (const double youngs_modulus : {1e9, 5e10})
      for (const double dt : {0.02, 0.01, 0.005})
        for (const double gap : {1e-4, 1e-3}) {
          StandardStepper stepper(wall(gap, dt, youngs_modulus, basis));
          const double fall = gap * 9.81 * 2500 * 0.5 * kColumns * kCourses;
          double least = 0;
          double made = 0;
          for (int step = 1; step <= 30; ++step) {
            support::run_to(stepper, step * dt);
            const double now = energy(stepper.ledger());
            made = std::max(made, now - least);
            least = std::min(least, now);
          }
          EXPECT_LT(made, 0.02 * fall) << (basis == BlockBasis::rigid ? "rigid, E " : "affine, E ") << youngs_modulus
                                       << ", dt " << dt << ", gap " << gap;
        }
}

}  // namespace keyblock::clean_up_test
