// check() reports all faults at once, and corrects what it can with a warning.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/checks/check.hpp"

#include <gtest/gtest.h>

namespace keyblock::check_test {
namespace {

Drawing sound_drawing() {
  Drawing drawing;
  drawing.edge_node_ratio = 0.01;
  drawing.joints = {{{{0, 0}, {1, 0}}, 0, {"g", 2, 1}}};
  drawing.fixed_lines = {{{{0, 0}, {0, 0}}, {}}};
  drawing.place = {"g"};
  return drawing;
}

Analysis sound_analysis() {
  Analysis analysis;
  analysis.block_materials.resize(2);
  analysis.joint_materials.resize(2);
  analysis.place = {"a"};
  return analysis;
}

std::vector<std::string> names(const Checked& checked) {
  std::vector<std::string> all;
  for (const Warning& warning : checked.warnings) all.push_back(warning.name);
  return all;
}

}  // namespace

TEST(Problem, sound_problem_has_no_complaints) {
  const Checked checked = check({sound_drawing(), sound_analysis()});
  EXPECT_EQ(checked.warnings, Warnings{});
  EXPECT_TRUE(checked.errors.empty());
}

TEST(Problem, materials_out_of_range_are_clamped_with_one_warning_a_number_at_its_first_place) {
  Drawing drawing = sound_drawing();
  drawing.joints.push_back({{{0, 0}, {1, 1}}, 8, {"g", 3, 1}});
  drawing.joints.push_back({{{0, 0}, {1, 2}}, 8, {"g", 4, 1}});
  drawing.joints.push_back({{{0, 0}, {1, 3}}, -1, {"g", 5, 1}});
  drawing.material_lines.push_back({{{0, 0}, {1, 1}}, 2, {"g", 6, 1}});
  const Checked checked = check({drawing, sound_analysis()});
  ASSERT_EQ(names(checked),
            (std::vector<std::string>{"joint_material_clamped", "joint_material_clamped", "block_material_clamped"}));
  EXPECT_EQ(to_string(checked.warnings[1]),
            "g:3:1: warning: joint material 9 of 2 lines is outside 1 to 2; taken as 2 [joint_material_clamped]");
  const Drawing& mended = std::get<Drawing>(checked.problem.geometry);
  EXPECT_EQ(mended.joints[1].joint_material, 1);
  EXPECT_EQ(mended.joints[3].joint_material, 0);
  EXPECT_EQ(mended.material_lines[0].block_material, 1);
}

TEST(Problem, materials_out_of_range_are_a_fault_of_a_case_file_that_holds_both) {
  Drawing drawing = sound_drawing();
  drawing.joints.push_back({{{0, 0}, {1, 1}}, 8, {"g", 3, 1}});
  Problem problem{drawing, sound_analysis()};
  problem.has_own_case = true;
  problem.analysis->place = {"other", 1, 1};  // an old drawing beside a present case file
  const Checked beside = check(problem);
  EXPECT_TRUE(beside.errors.empty());
  EXPECT_EQ(names(beside), std::vector<std::string>{"joint_material_clamped"});
  problem.analysis->place = {"g", 1, 1};
  const Checked own = check(problem);
  EXPECT_TRUE(own.warnings.empty());
  ASSERT_EQ(own.errors.size(), 1U);
  EXPECT_STREQ(own.errors[0].what(), "g:3:1: error: expected a joint material from 1 to 2, found 9 (of 1 lines)");
}

TEST(Problem, lines_without_length_are_left_out_and_boundaries_still_counted) {
  Drawing drawing = sound_drawing();
  drawing.joints.insert(drawing.joints.begin(), {{{1, 1}, {1, 1}}, 0, {"g", 1, 1}});
  drawing.boundary_count = 2;
  const Checked checked = check({drawing, {}});
  EXPECT_EQ(names(checked), std::vector<std::string>{"zero_length_line"});
  EXPECT_EQ(std::get<Drawing>(checked.problem.geometry).joints.size(), 1u);
  EXPECT_EQ(std::get<Drawing>(checked.problem.geometry).boundary_count, 1u);
}

TEST(Problem, missing_fixed_points_and_unusual_edge_node_ratio_are_warnings) {
  Drawing drawing = sound_drawing();
  drawing.fixed_lines.clear();
  drawing.edge_node_ratio = 0.5;
  EXPECT_EQ(names(check({drawing, {}})), (std::vector<std::string>{"edge_node_ratio_unusual", "no_fixed_points"}));
}

TEST(Problem, missing_fixed_points_are_a_note_without_weight) {
  Drawing drawing = sound_drawing();
  drawing.fixed_lines.clear();
  Analysis analysis = sound_analysis();
  EXPECT_EQ(names(check({drawing, analysis})), std::vector<std::string>{"free_without_gravity"});
  analysis.gravity = 9.81;
  EXPECT_EQ(names(check({drawing, analysis})), std::vector<std::string>{"no_fixed_points"});
}

TEST(Problem, drawing_without_lines_is_an_error) {
  Drawing drawing = sound_drawing();
  drawing.joints.clear();
  const Checked checked = check({drawing, {}});
  ASSERT_EQ(checked.errors.size(), 1u);
  EXPECT_STREQ(checked.errors[0].what(), "g: error: expected lines to cut blocks from, found none");
}

TEST(Problem, more_or_fewer_load_curves_than_loading_points_are_warnings) {
  Analysis analysis = sound_analysis();
  analysis.point_loads.resize(1);
  EXPECT_EQ(names(check({sound_drawing(), analysis})), std::vector<std::string>{"surplus_load_curves"});
  Drawing drawing = sound_drawing();
  drawing.loading_points.resize(2);
  EXPECT_EQ(names(check({drawing, analysis})), std::vector<std::string>{"loading_points_without_load"});
}

TEST(Problem, bolts_that_state_no_properties_get_those_of_their_type) {
  Analysis analysis = sound_analysis();
  analysis.bolt_properties = {{1, 2, 3}, {4, 5, 6}};
  Drawing drawing = sound_drawing();
  drawing.bolts.resize(2);
  drawing.bolts[0].segment = drawing.bolts[1].segment = {{0, 0}, {1, 1}};
  drawing.bolts[1].type = 7;
  const Checked checked = check({drawing, analysis});
  EXPECT_EQ(names(checked), std::vector<std::string>{"bolt_type_clamped"});
  EXPECT_EQ(std::get<Drawing>(checked.problem.geometry).bolts[0].stiffness, 1);
  EXPECT_EQ(std::get<Drawing>(checked.problem.geometry).bolts[1].pretension, 6);
}

TEST(Problem, bolts_that_state_their_properties_keep_them) {
  Analysis analysis = sound_analysis();
  analysis.bolt_properties = {{1, 2, 3}};
  Drawing drawing = sound_drawing();
  drawing.bolts = {{{{0, 0}, {1, 1}}, 7, 8, 9, 0, {}}};
  const Checked checked = check({drawing, analysis});
  EXPECT_EQ(checked.warnings, Warnings{});
  EXPECT_EQ(std::get<Drawing>(checked.problem.geometry).bolts[0].stiffness, 7);
}

TEST(Problem, bolts_without_any_properties_are_a_warning) {
  Drawing drawing = sound_drawing();
  drawing.bolts = {{{{0, 0}, {1, 1}}, 0, 0, 0, 0, {}}};
  EXPECT_EQ(names(check({drawing, sound_analysis()})), std::vector<std::string>{"bolts_without_properties"});
}

TEST(Problem, bolt_of_a_block_file_without_length_is_left_out) {
  Blocks blocks;
  blocks.fixed_points.resize(1);
  blocks.bolts.resize(2);
  blocks.bolts[1].segment = {{0, 0}, {1, 0}};
  const Checked checked = check({blocks, {}});
  EXPECT_EQ(names(checked), std::vector<std::string>{"zero_length_bolt"});
  EXPECT_EQ(std::get<Blocks>(checked.problem.geometry).bolts.size(), 1U);
}

TEST(Problem, block_that_turns_clockwise_is_an_error) {
  Blocks blocks;
  blocks.place = {"b"};
  blocks.fixed_points.resize(1);
  blocks.blocks = {{0, {{{0, 0}, 0}, {{0, 1}, 0}, {{1, 0}, 0}}, {}}};
  const Checked checked = check({blocks, {}});
  ASSERT_EQ(checked.errors.size(), 1u);
  EXPECT_STREQ(checked.errors[0].what(),
               "b: error: expected block 1 of 1 counter-clockwise with an area, found area -0.5");
}

TEST(Problem, a_bolt_of_negative_stiffness_is_an_error) {
  Drawing drawing = sound_drawing();
  drawing.bolts = {{{{0, 0}, {1, 1}}, -7, 8, 9, 0, {"g", 5, 1}}};
  const Checked of_drawing = check({drawing, sound_analysis()});
  ASSERT_EQ(of_drawing.errors.size(), 1U);
  EXPECT_STREQ(of_drawing.errors[0].what(),
               "g:5:1: error: expected a stiffness of at least 0 of bolt 1 of 1, found -7");
  Blocks blocks;
  blocks.bolts = {{{{0, 0}, {1, 1}}, 0, 0, -7, 8, 9}, {{{0, 0}, {1, 1}}, 0, 0, 0, 8, 9}};
  EXPECT_EQ(check({blocks, sound_analysis()}).errors.size(), 1U);
}

}  // namespace keyblock::check_test
