// Blocks that meet within a step: what the clean-up of velocities leaves must not make energy in the next one.
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

struct PushedWall {
  int columns, courses;
  double gap, youngs_modulus, penalty_factor, friction_deg, speed, dt;
};

// Walls in running bond, above a floor that is much larger, whose bricks move sideways: they rock as they land.
Scene pushed_wall(const PushedWall& of) {
  Blocks blocks;
  blocks.blocks = {rectangle({-20, -1}, {30, 0})};
  blocks.fixed_points = {{{-19, -0.5}, 0, {}}, {{29, -0.5}, 0, {}}};
  for (int course = 0; course < of.courses; ++course)
    for (int column = 0; column < of.columns; ++column) {
      const double x = column + (course % 2) * 0.5;
      const double y = of.gap + course * 0.5;
      blocks.blocks.push_back(rectangle({x, y}, {x + 1, y + 0.5}));
      blocks.blocks.back().material = 2;
    }
  Analysis analysis = plain_analysis(of.dt, 1);
  analysis.penalty_factor = of.penalty_factor;
  analysis.block_materials[0].youngs_modulus = of.youngs_modulus;
  analysis.block_materials.push_back(analysis.block_materials[0]);
  analysis.block_materials[1].initial_velocity = {of.speed, 0, 0};
  analysis.joint_materials[0].friction_angle_deg = of.friction_deg;
  Settings settings = standard_settings(analysis);
  settings.standard.enforcement = Enforcement::penalty;
  settings.ledger = Bookkeeping::on;
  return standard_scene_of(blocks, analysis, settings);
}

// Such walls gained 4 to 36 % of their energy. Impulses pulled, or stopped at blocks that had not met. Contacts held
// what was about to open. Tangential springs were longer than friction lets them be.
TEST(CleanUp, a_wall_that_lands_while_it_is_pushed_sideways_makes_no_energy) {
  for (const PushedWall& of :
       {PushedWall{4, 5, 3.656e-4, 1.5e10, 5, 45, 0.1, 0.01}, PushedWall{1, 3, 0, 8.9e9, 500, 45, 0.3, 0.02},
        PushedWall{3, 5, 0, 1.8e10, 5, 35, 0.1, 0.02}}) {
    StandardStepper stepper(pushed_wall(of));
    double least = energy(stepper.ledger());
    const double had = least;
    double made = 0;
    for (int step = 1; step <= 40; ++step) {
      support::run_to(stepper, step * of.dt);
      const double now = energy(stepper.ledger());
      made = std::max(made, now - least);
      least = std::min(least, now);
    }
    EXPECT_LT(made, 0.02 * had) << of.columns << " columns, " << of.courses << " courses, dt " << of.dt;
  }
}

// The first part of the step ends microseconds after the upper block has met the lower one, which resolves the strains
// of its blocks; the rest of the step does not.
TEST(CleanUp, an_impact_within_a_step_leaves_stiff_blocks_no_strain_rate) {
  Blocks blocks;
  blocks.blocks = {rectangle({-5, -1}, {5, 0}), rectangle({0, 0}, {0.5, 1}), rectangle({0, 1.000001}, {0.5, 2.000001})};
  blocks.blocks[1].material = 1;
  blocks.blocks[2].material = 2;
  blocks.fixed_points = {{{-4, -0.5}, 0, {}}, {{4, -0.5}, 0, {}}};
  for (const Enforcement enforcement : {Enforcement::penalty, Enforcement::lagrange})
    for (const double dt : {0.02, 0.01, 0.005}) {
      Analysis analysis = plain_analysis(dt, 1);
      analysis.penalty_factor = 50;
      analysis.joint_materials[0].friction_angle_deg = 45;
      analysis.block_materials[0].youngs_modulus = 8e10;
      analysis.block_materials.resize(3, analysis.block_materials[0]);
      analysis.block_materials[1].initial_velocity = {-0.27, -0.13, 0};
      analysis.block_materials[2].initial_velocity = {0.07, -0.43, 0};
      Settings settings = standard_settings(analysis);
      settings.standard.enforcement = enforcement;
      settings.ledger = Bookkeeping::on;
      StandardStepper stepper(standard_scene_of(blocks, analysis, settings));
      const double began = energy(stepper.ledger());
      for (int step = 1; step <= 20; ++step) {
        support::run_to(stepper, step * dt);
        EXPECT_LT(energy(stepper.ledger()), began) << "dt " << dt << ", step " << step;
      }
    }
}

}  // namespace keyblock::clean_up_test
