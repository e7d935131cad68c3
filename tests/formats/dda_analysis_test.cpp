// The native analysis files: Berkeley's and Shi's, with and without the geometry that Shi's needs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/shi/dda_analysis.hpp"

#include <gtest/gtest.h>

#include "formats/berkeley/ddaml.hpp"
#include "formats/registry.hpp"
#include "tests/formats/reading.hpp"

namespace keyblock::formats::dda_analysis_test {
namespace {

const std::string kMaterials = "5 161 1e6 .25\n1 2 3\n4 5 6\n7 8 9\n10 11 12\n";
const std::string kBerkeley = "0.7\n20\n1\n1\n0.006\n0.01\n" + kMaterials;

std::string shi(const std::string& points_and_rows) {
  return "1 20 1 1 .006 .01 1e7\n" + points_and_rows + "\n" + kMaterials + "1.5\n";
}

}  // namespace

TEST(DdaAnalysis, berkeley_values_land_in_their_places) {
  const Reading reading = read({"f", kBerkeley});
  EXPECT_EQ(reading.warnings, Warnings{});
  const Analysis& analysis = *reading.content.analysis;
  EXPECT_EQ(analysis.dialect, AnalysisDialect::berkeley);
  EXPECT_EQ(analysis.velocity_carry_over, 0.7);
  EXPECT_EQ(analysis.step_count, 20);
  EXPECT_EQ(analysis.allowed_displacement_ratio, 0.006);
  EXPECT_EQ(analysis.time_step, 0.01);
  ASSERT_EQ(analysis.block_materials.size(), 1u);
  const BlockMaterial& block = analysis.block_materials[0];
  EXPECT_EQ(block.density, 5);
  EXPECT_EQ(block.unit_weight, 161);
  EXPECT_EQ(block.youngs_modulus, 1e6);
  EXPECT_EQ(block.poissons_ratio, .25);
  EXPECT_EQ(block.initial_stress, (Stress{1, 2, 3}));
  EXPECT_EQ(block.stress_gradient, (Stress{4, 5, 6}));
  EXPECT_EQ(block.initial_velocity, (Velocity{7, 8, 9}));
  ASSERT_EQ(analysis.joint_materials.size(), 1u);
  EXPECT_EQ(analysis.joint_materials[0].friction_angle_deg, 10);
  EXPECT_EQ(analysis.joint_materials[0].cohesion, 11);
  EXPECT_EQ(analysis.joint_materials[0].tensile_strength, 12);
}

TEST(DdaAnalysis, native_files_take_the_choices_of_berkeleys_native_reader) {
  const Analysis analysis = *read({"f", kBerkeley}).content.analysis;
  EXPECT_TRUE(analysis.automatic_time_step);
  EXPECT_TRUE(analysis.automatic_penalty);
  EXPECT_FALSE(analysis.plane_strain);
  EXPECT_EQ(analysis.penalty_factor, 50);
  EXPECT_EQ(analysis.contact_penalty, std::nullopt);
}

TEST(DdaAnalysis, written_text_is_read_back_to_the_same_text) {
  const std::string text = kDdaAnalysisBerkeley.write(read({"f", kBerkeley}).content);
  EXPECT_EQ(kDdaAnalysisBerkeley.write(read({"f", text}).content), text);
}

TEST(DdaAnalysis, shi_curves_go_to_fixed_and_loading_points) {
  const Reading reading = read({"f", shi("0 2 3\n0 0 0 5 .1 .2\n0 10 20 1 30 40 2 0 0")}, {2, 1});
  EXPECT_EQ(reading.warnings, Warnings{});
  const Analysis& analysis = *reading.content.analysis;
  EXPECT_EQ(analysis.dialect, AnalysisDialect::shi);
  EXPECT_EQ(analysis.contact_penalty, 1e7);
  EXPECT_EQ(analysis.over_relaxation, 1.5);
  ASSERT_EQ(analysis.fixed_point_motions.size(), 2u);
  EXPECT_TRUE(analysis.fixed_point_motions[0].times.empty());
  EXPECT_EQ(analysis.fixed_point_motions[1].values, (std::vector<Point>{{0, 0}, {.1, .2}}));
  ASSERT_EQ(analysis.point_loads.size(), 1u);
  EXPECT_EQ(analysis.point_loads[0].times, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(analysis.block_materials.at(0).density, 5);
}

TEST(DdaAnalysis, shi_text_has_a_flag_for_every_point_of_the_blocks_and_two_rows_for_a_constant) {
  Content content = read({"f", shi("0 2 3\n0 0 0 5 .1 .2\n0 10 20 1 30 40 2 0 0")}, {2, 1}).content;
  content.analysis->point_loads = {{{0}, {{7, 8}}, {}}};
  content.blocks.emplace();
  content.blocks->fixed_points.resize(3);
  content.blocks->loading_points.resize(2);
  const std::string text = kDdaAnalysisShi.write(content);
  EXPECT_NE(text.find("1e+07\n0\n2\n0\n2\n0\n0 0 0\n5 0.1 0.2\n0 7 8\n1e+05 7 8\n5 161 "), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("\n1.5\n"));
}

// The second row follows the first at any time.
TEST(DdaAnalysis, a_constant_that_begins_late_is_written_and_read) {
  Content content = read({"f", shi("0 0")}, {1, 1}).content;
  for (const double time : {1e30, -1e30, 1e308}) {
    content.analysis->point_loads = {{{time}, {{7, 8}}, {}}};
    for (const Format* format : {&kDdaAnalysisShi, &kDdaml}) {
      const TimeCurve load = format->read({"f", format->write(content)}, {1, 1}).content.analysis->point_loads.at(0);
      EXPECT_EQ(load.times.at(0), time) << format->name;
      EXPECT_EQ(load.at(time), (Point{7, 8})) << format->name;
    }
  }
}

TEST(DdaAnalysis, shi_file_without_curves_is_read_without_geometry) {
  const Reading reading = read({"f", shi("0 0 0")});
  EXPECT_EQ(reading.content.analysis->dialect, AnalysisDialect::shi);
  EXPECT_EQ(reading.content.analysis->joint_materials.at(0).cohesion, 11);
}

TEST(DdaAnalysis, shi_file_with_curves_asks_for_the_geometry) {
  EXPECT_EQ(error_of(shi("0 2\n0 0 0 5 .1 .2")),
            "f:3:1: error: expected the block or geometry file of this analysis, to know whether these time "
            "rows move a fixed "
            "point or load a loading point; found none");
  EXPECT_EQ(error_of(shi("0 2\n0 0 0 5 .1 .2"), {std::nullopt, 1}), "");
}

TEST(DdaAnalysis, flag_of_one_row_is_an_error) {
  const Source source{"f", "1 20 1 1 .006 .01 1e7\n0 1 0 5 5\n" + kMaterials + "1.5"};
  try {
    kDdaAnalysisShi.read(source, {1, 1});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "f:2:3: error: expected the number of time rows of fixed or loading point 2 of 2 (0, or 2 and "
                 "more), found \"1\"");
  }
}

TEST(DdaAnalysis, times_that_do_not_increase_are_an_error_at_the_time) {
  const Source source{"f", shi("2\n1 0 0 1 0 0")};
  try {
    kDdaAnalysisShi.read(source, {1, 0});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "f:3:7: error: expected the time of row 2 of 2 (greater than 1), found \"1\"");
  }
}

TEST(DdaAnalysis, contact_stiffness_zero_means_the_programs_choice) {
  const Reading reading = read({"f", "1 20 1 1 .006 .01 0\n0 0\n" + kMaterials});
  EXPECT_EQ(names(reading.warnings), std::vector<std::string>{"contact_stiffness_zero"});
  EXPECT_EQ(reading.content.analysis->contact_penalty, std::nullopt);
}

TEST(DdaAnalysis, impossible_values_are_errors_at_their_token) {
  const auto replaced = [](const std::string& from, const std::string& to) {
    std::string text = kBerkeley;
    return error_of(text.replace(text.find(from), from.size(), to));
  };
  EXPECT_EQ(replaced("5 161", "0 161"),
            "f:7:1: error: expected the mass per unit area of block material 1 of 1 (greater than 0), found \"0\"");
  EXPECT_NE(replaced("1e6", "-1e6"), "");
  EXPECT_NE(replaced(".25", ".51"), "");
  EXPECT_NE(replaced("10 11", "90 11"), "");
  EXPECT_NE(replaced("0.006", "0"), "");
  EXPECT_NE(replaced("0.01\n", "0\n"), "");
  EXPECT_NE(replaced("20\n", "100000001\n"), "");
  EXPECT_NE(replaced("20\n", "0\n"), "");
}

// Spec section 4, item 12: the message names the mistake at its place, not a fault of Berkeley's dialect.
TEST(DdaAnalysis, a_faulty_curve_of_a_shi_file_is_named_where_it_stands) {
  const std::string head = "1 5 1 1 0.01 0.01 1e6\n";
  const std::string tail = "2.5 24.5 1e6 0.2 0 0 0 0 0 0 0 0 0\n30 0 0\n1.4\n";
  const ReadHint hint{1, 1};
  EXPECT_EQ(error_of(head + "0 1\n1 1 0\n" + tail, hint),
            "f:2:3: error: expected the number of time rows of fixed or loading point 2 of 2 (0, or 2 and more), found "
            "\"1\"");
  EXPECT_EQ(error_of(head + "0 2\n2 1 0 1 1 0\n" + tail, hint),
            "f:3:7: error: expected the time of row 2 of 2 (greater than 2), found \"1\"");
}

TEST(DdaAnalysis, time_rows_of_another_geometry_are_named_as_such) {
  EXPECT_EQ(error_of(shi("0 2 0\n0 0 0 5 .1 .2"), {1, 1}),
            "f:2:1: error: expected time rows of 1 fixed and 1 loading points, as many as its geometry has, found "
            "those of 3 points");
}

}  // namespace keyblock::formats::dda_analysis_test
