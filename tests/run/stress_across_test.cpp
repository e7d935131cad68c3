// Stress across the plane is the same for every kind of body: a block under either dynamics, covers in steps, covers at
// once.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "run/prepare.hpp"
#include "run/run.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::stress_across_test {
namespace {

/// A weightless square whose material is under stress across the plane alone, and measured at its middle.
Problem square(bool on_covers) {
  Problem problem;
  Blocks blocks;
  blocks.blocks = {support::rectangle({0, 0}, {2, 2})};
  blocks.measured_points = {{{0.9, 1.1}, 0, {}}};
  problem.analysis = support::plain_analysis(1e-3, 3);
  problem.analysis->velocity_carry_over = 0;
  problem.analysis->plane_strain = true;
  problem.analysis->gravity = 0;
  BlockMaterial& rock = problem.analysis->block_materials[0];
  rock.unit_weight = 0;
  rock.gives_zz = true;
  rock.initial_stress = {0, 0, 0, -5e6};
  rock.stress_gradient = {0, 0, 0, 1e6};
  if (on_covers) {
    problem.covers.emplace();
    problem.covers->mesh.side = 0.7;
    problem.covers->displacements = {{{{0, 0}, {2, 0}}, Held::both, {}, {}, {}, {}}};
  } else {
    blocks.fixed_points = {{{0.1, 0.1}, 0, {}}, {{1.9, 0.1}, 0, {}}};
  }
  problem.geometry = blocks;
  return problem;
}

Frame last_frame(const Problem& problem, const std::string& profile) {
  Frame last;
  Observer observer;
  observer.on_frame = [&](const Frame& frame) { last = frame; };
  run(prepare(problem, profile, {}).scene, 1, observer);
  return last;
}

}  // namespace

TEST(StressAcross, of_a_block_is_that_of_its_centroid) {
  for (const char* profile : {"standard", "legacy"}) {
    const Frame frame = last_frame(square(false), profile);
    EXPECT_DOUBLE_EQ(frame.elements[0].stress.zz, -4e6) << profile;
    EXPECT_NEAR(frame.elements[0].stress.yy, 0, 1e-3) << profile;
  }
}

TEST(StressAcross, on_covers_is_that_of_the_point_in_steps_and_at_once) {
  const Frame in_steps = last_frame(square(true), "standard");
  EXPECT_NEAR(in_steps.measured_points.at(0).stress.zz, -3.9e6, 1e-3);
  Problem at_once = square(true);
  at_once.covers->contact = CoverContact::ignored;
  EXPECT_NEAR(last_frame(at_once, "standard").measured_points.at(0).stress.zz, -3.9e6, 1e-3);
}

// Under its own field, given or not: ν (xx + yy) with -3 and -2, or else the given value.
TEST(StressAcross, of_a_field_is_what_it_says_or_what_goes_with_it) {
  for (const bool is_given : {false, true}) {
    Problem problem = square(true);
    problem.analysis->block_materials[0].gives_zz = false;
    problem.analysis->block_materials[0].initial_stress = {};
    problem.analysis->block_materials[0].poissons_ratio = 0.25;
    problem.covers->contact = CoverContact::ignored;
    problem.covers->initial_stress = {{"-3", {}}, {"-2", {}}, {}};
    if (is_given) problem.covers->initial_stress.zz = Formula{"-7 + y", {}};
    Frame start;
    Observer observer;
    observer.on_frame = [&](const Frame& frame) {
      if (frame.step == 0) start = frame;
    };
    run(prepare(problem, "standard", {}).scene, 1, observer);
    EXPECT_NEAR(start.measured_points.at(0).stress.zz, is_given ? -5.9 : -1.25, 1e-12);
  }
}

}  // namespace keyblock::stress_across_test
