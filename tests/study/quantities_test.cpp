// The quantities of blocks, points and the scene, compared with two blocks worked out by hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/cases/quantities.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock::study::quantities_test {
namespace {

/// A block of mass 3 and moment of inertia 2 at (1, 2), one of mass 1 at (5, 6), and a point; areas 4 and 2.
Frame two_blocks() {
  Frame frame;
  ElementFrame a;
  a.centroid = {1, 2};
  a.area = 4;
  a.mass = 3;
  a.moment_of_inertia = 2;
  ElementFrame b;
  b.centroid = {5, 6};
  b.area = 2;
  b.mass = 1;
  frame.elements = {a, b};
  frame.measured_points = {{{7, 8}, {0, 0}, 0}};
  return frame;
}

/// The first block moves at (3, 4) and spins at 5, the second lost a tenth of its area and moves at (-2, 0).
Frame moved() {
  Frame frame = two_blocks();
  frame.step = 1;
  frame.elements[0].centroid = {1.5, 1};
  frame.elements[0].displacement = {0.5, -1};
  frame.elements[0].velocity = {3, 4, 5};
  frame.elements[1].velocity = {-2, 0, 0};
  frame.elements[1].area = 1.8;
  frame.measured_points = {{{7.5, 7.25}, {0.5, -0.75}, 0}};
  return frame;
}

RunSoFar run_of(const std::vector<Frame>& frames) {
  RunSoFar run;
  for (const Frame& frame : frames) run.add(frame);
  return run;
}

}  // namespace

TEST(Quantities, have_one_owner_each) {
  EXPECT_EQ(owner_of("spin"), Owner::block);
  EXPECT_EQ(owner_of("point_dx"), Owner::point);
  EXPECT_EQ(owner_of("kinetic_energy"), Owner::scene);
  EXPECT_FALSE(owner_of("colour"));
}

TEST(Quantities, of_a_block_and_of_a_point_are_found_by_their_number) {
  const RunSoFar run = run_of({two_blocks(), moved()});
  EXPECT_EQ(quantity_of(run, "vx", 1), 3);
  EXPECT_EQ(quantity_of(run, "vy", 1), 4);
  EXPECT_EQ(quantity_of(run, "speed", 1), 5);
  EXPECT_EQ(quantity_of(run, "spin", 1), 5);
  EXPECT_EQ(quantity_of(run, "vx", 2), -2);
  EXPECT_EQ(quantity_of(run, "displacement", 1), std::hypot(0.5, -1));
  EXPECT_EQ(quantity_of(run, "py", 1), 7.25);
  EXPECT_EQ(quantity_of(run, "point_dy", 1), -0.75);
}

// A compatible start moves blocks before the first step: displacement counts from before it, travel from after it.
TEST(Quantities, travel_is_counted_from_the_first_frame) {
  Frame settled = two_blocks();
  settled.elements[0].centroid = {1, 1.5};
  settled.elements[0].displacement = {0, -0.5};
  const RunSoFar run = run_of({settled, moved()});
  EXPECT_EQ(quantity_of(run, "travel", 1), std::hypot(0.5, -0.5));
  EXPECT_EQ(quantity_of(run, "travel", 2), 0);
}

TEST(Quantities, of_the_scene_are_sums_over_all_blocks) {
  const RunSoFar run = run_of({two_blocks(), moved()});
  EXPECT_DOUBLE_EQ(quantity_of(run, "kinetic_energy", {}), (3 * 25 + 2 * 25 + 1 * 4) / 2.0);
  EXPECT_DOUBLE_EQ(quantity_of(run, "momentum_x", {}), 3 * 3 - 2);
  EXPECT_DOUBLE_EQ(quantity_of(run, "momentum_y", {}), 3 * 4);
  EXPECT_DOUBLE_EQ(quantity_of(run, "centre_of_mass_x", {}), (3 * 1.5 + 5) / 4);
  EXPECT_DOUBLE_EQ(quantity_of(run, "centre_of_mass_y", {}), (3 * 1 + 6) / 4.0);
  EXPECT_DOUBLE_EQ(quantity_of(run, "total_area", {}), 5.8);
  EXPECT_DOUBLE_EQ(quantity_of(run, "area_change", {}), 0.1);
  EXPECT_DOUBLE_EQ(quantity_of(run, "greatest_speed", {}), 5);
}

TEST(Quantities, that_are_the_greatest_until_then_do_not_come_down_again) {
  const RunSoFar run = run_of({two_blocks(), moved(), two_blocks()});
  EXPECT_DOUBLE_EQ(quantity_of(run, "area_change", {}), 0);
  EXPECT_DOUBLE_EQ(quantity_of(run, "greatest_area_change", {}), 0.1);
  EXPECT_DOUBLE_EQ(quantity_of(run_of({two_blocks(), moved()}), "greatest_centre_of_mass_y", {}), 3) << "at the start";
  EXPECT_DOUBLE_EQ(quantity_of(run_of({moved(), two_blocks(), moved()}), "greatest_centre_of_mass_y", {}), 3);
}

TEST(Quantities, a_step_that_was_cut_or_left_a_contact_undecided_did_not_converge) {
  RunSoFar run;
  EXPECT_EQ(run.converged_share(), 1);
  StepReport cut;
  cut.redos = 1;
  StepReport undecided;
  undecided.unsettled_contacts = 2;
  for (const StepReport& step : {StepReport{}, StepReport{}, cut, undecided}) run.add(step);
  EXPECT_EQ(run.converged_share(), 0.5);
}

}  // namespace keyblock::study::quantities_test
