// The analysis file of Shi's manifold program: alone, beside its cover, and if Shi's DDA dialect would fit as well.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/shi/nmm_analysis.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "formats/case.hpp"
#include "tests/formats/reading.hpp"
#include "tests/support/text_files.hpp"
#include "tests/support/two_triangles.hpp"

namespace keyblock::formats::nmm_analysis_test {
namespace {

const std::string kHead = "0.7\n10\n1\n1\n0.01\n0.1\n500\n";
const std::string kMaterials = "0.1\n0.5 -1\n10 0.2\n1 2 3\n4 5 6\n7 8 9\n30 1 2\n";
const std::string kFile = kHead + "2 -3\n" + kMaterials + "1.5\n0 0 0\n";

/// Four points of which the last has two time rows, or three loads and a material of ma 5, E 7, nu 0.1.
const std::string kAmbiguous = "1 10 1 1 .01 .1 500\n0 0 0 2\n0 1 5 1 2 7\n.1 1 1 .2  0 0 0 0 0 0 0 0 0\n30 0 0\n1";

std::string read_beside(const std::string& geometry, const std::string& analysis) {
  const auto folder = std::filesystem::temp_directory_path() / "keyblock_nmm_analysis_test";
  std::filesystem::create_directories(folder);
  keyblock::support::write_text(folder / "geometry", geometry);
  keyblock::support::write_text(folder / "analysis", analysis);
  const auto files = read_files({(folder / "analysis").string(), (folder / "geometry").string()});
  std::filesystem::remove_all(folder);
  if (!files[0].choice) return files[0].error->sentence();
  return std::string(files[0].choice->format->name) + (files[0].error ? ": " + files[0].error->sentence() : "");
}

}  // namespace

TEST(NmmAnalysis, every_value_lands_in_its_place) {
  const Reading reading = read({"f", kFile});
  EXPECT_EQ(reading.warnings, Warnings{});
  const Analysis& analysis = *reading.content.analysis;
  EXPECT_EQ(analysis.dialect, AnalysisDialect::manifold);
  EXPECT_EQ(analysis.velocity_carry_over, 0.7);
  EXPECT_EQ(analysis.step_count, 10);
  EXPECT_EQ(analysis.allowed_displacement_ratio, 0.01);
  EXPECT_EQ(analysis.time_step, 0.1);
  EXPECT_EQ(analysis.contact_penalty, 500);
  EXPECT_EQ(analysis.over_relaxation, 1.5);
  ASSERT_EQ(analysis.point_loads.size(), 1u);
  EXPECT_EQ(analysis.point_loads[0].at(7), (Point{2, -3}));
  const BlockMaterial& material = analysis.block_materials.at(0);
  EXPECT_EQ(material.density, 0.1);
  EXPECT_EQ(material.horizontal_force, 0.5);
  EXPECT_EQ(material.unit_weight, 1);  // down is a weight
  EXPECT_EQ(material.youngs_modulus, 10);
  EXPECT_EQ(material.poissons_ratio, 0.2);
  EXPECT_EQ(material.initial_stress, (Stress{1, 2, 3}));
  EXPECT_EQ(material.stress_gradient, (Stress{4, 5, 6}));
  EXPECT_EQ(material.initial_velocity, (Velocity{7, 8, 9}));
  EXPECT_EQ(analysis.joint_materials.at(0).cohesion, 1);
}

TEST(NmmAnalysis, writing_gives_the_words_of_the_layout) {
  EXPECT_EQ(kNmmAnalysis.write(read({"f", kFile}).content), kFile);
}

TEST(NmmAnalysis, text_behind_and_final_numbers_that_are_not_zero_are_warnings) {
  const Reading reading = read({"f", kHead + "2 -3\n" + kMaterials + "1.5\n0 1 0\n\npen=0.1*g0;%force"});
  EXPECT_EQ(names(reading.warnings), (std::vector<std::string>{"final_numbers_ignored", "trailing_text"}));
}

TEST(NmmAnalysis, loads_that_change_with_time_are_not_written) {
  Content content = read({"f", kFile}).content;
  content.analysis->point_loads = {{{0, 1}, {{1, 0}, {2, 0}}, {}}};
  EXPECT_THROW(kNmmAnalysis.write(content), std::invalid_argument);
}

TEST(NmmAnalysis, geometry_beside_it_decides_between_two_dialects) {
  EXPECT_NE(error_of(kAmbiguous).find("expected the geometry of this file, which fits two formats"), std::string::npos);
  EXPECT_EQ(read({"f", kAmbiguous}, {3, 1, GeometryKind::blocks}).content.analysis->dialect, AnalysisDialect::shi);
  EXPECT_EQ(read({"f", kAmbiguous}, {{}, 3, GeometryKind::cover}).content.analysis->dialect, AnalysisDialect::manifold);
}

TEST(NmmAnalysis, is_read_beside_its_cover_whichever_is_named_first) {
  EXPECT_EQ(read_beside(keyblock::support::kTwoTrianglesFile, kFile), "nmm-analysis");
  EXPECT_EQ(read_beside(keyblock::support::kTwoTrianglesFile, kHead + kMaterials + "1.5\n0 0 0\n"),
            "nmm-analysis: expected the loads of 1 loading points, as many as its geometry has, found "
            "those of 0");
  EXPECT_EQ(read_beside(keyblock::support::kTwoTrianglesFile, kHead + "2 -3\n0.1 0.5"),
            "nmm-analysis: expected the force per unit area in y of block material 1 of 1, found end of file");
}

TEST(NmmAnalysis, faults_are_named_at_their_place) {
  std::string text = kFile;
  text.replace(text.find("10 0.2"), 6, "10 0.7");
  EXPECT_EQ(error_of(text, {{}, 1, GeometryKind::cover}),
            "f:11:4: error: expected Poisson's ratio of block material 1 of 1 (0 to 0.5), found \"0.7\"");
}

TEST(NmmAnalysis, loads_of_another_cover_are_named_as_such) {
  EXPECT_EQ(error_of(kFile, {std::nullopt, 3, GeometryKind::cover}),
            "f:8:1: error: expected the loads of 3 loading points, as many as its geometry has, found "
            "those of 1");
}

}  // namespace keyblock::formats::nmm_analysis_test
