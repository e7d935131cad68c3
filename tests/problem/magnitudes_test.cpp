// Overflowing numbers are refused at their place; the infinities of old files, 1e99 and below, are not.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/checks/magnitudes.hpp"

#include <gtest/gtest.h>

namespace keyblock::magnitudes_test {
namespace {

Problem sound() {
  Problem problem;
  Drawing drawing;
  drawing.joints = {{{{0, 0}, {1, 0}}, 0, {"g", 2, 1}}, {{{0, 0}, {1, 1}}, 0, {"g", 3, 1}}};
  drawing.place = {"g"};
  problem.geometry = drawing;
  Analysis analysis;
  analysis.place = {"a"};
  analysis.time_step_place = {"a", 4, 7};
  analysis.time_step = 1e-3;
  analysis.allowed_displacement_ratio = 0.01;
  analysis.block_materials.resize(1);
  analysis.block_materials[0].density = 1;
  analysis.block_materials[0].youngs_modulus = 1;
  analysis.block_materials[0].place = {"a", 9, 1};
  analysis.joint_materials.resize(1);
  problem.analysis = analysis;
  return problem;
}

std::string complaint(const Problem& problem) {
  const std::vector<InputError> errors = immeasurable(problem);
  return errors.empty() ? "" : errors.front().what();
}

}  // namespace

TEST(Magnitudes, what_engineers_write_and_the_infinities_of_old_files_pass) {
  Problem problem = sound();
  EXPECT_EQ(complaint(problem), "");
  problem.analysis->joint_materials[0].cohesion = 1e99;
  problem.analysis->block_materials[0].unit_weight = -1e99;
  problem.analysis->time_step = 1e-99;
  EXPECT_EQ(complaint(problem), "");
}

TEST(Magnitudes, steps_loads_materials_and_coordinates_beyond_them_are_named_at_their_place) {
  Problem problem = sound();
  problem.analysis->time_step = 1e308;
  EXPECT_EQ(complaint(problem), "a:4:7: error: expected the time step from 1e-100 to 1e+100, found 1e+308");
  problem = sound();
  problem.analysis->block_materials[0].unit_weight = 1e155;
  EXPECT_EQ(complaint(problem),
            "a:9:1: error: expected the unit weight of the block material from -1e+100 to 1e+100, found 1e+155");
  problem = sound();
  problem.analysis->point_loads = {{{0}, {{0, -1e300}}, {"a", 12, 1}}};
  EXPECT_EQ(complaint(problem), "a:12:1: error: expected the load from -1e+100 to 1e+100, found -1e+300");
  problem = sound();
  std::get<Drawing>(problem.geometry).joints[1].segment.end.y = 1e150;
  EXPECT_EQ(complaint(problem), "g:3:1: error: expected coordinates of the line from -1e+50 to 1e+50, found 1e+150");
}

TEST(Magnitudes, a_geometry_whose_areas_underflow_is_refused) {
  Problem problem = sound();
  for (JointLine& line : std::get<Drawing>(problem.geometry).joints) line.segment.end = 1e-160 * line.segment.end;
  EXPECT_EQ(complaint(problem), "g:2:1: error: expected a geometry that extends over 1e-50 at least, found 1e-160");
}

}  // namespace keyblock::magnitudes_test
