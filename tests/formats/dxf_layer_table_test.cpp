// The table of the layers of a drawing, and the messages about faults in it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/dxf_layer_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/formats/dxf_samples.hpp"
#include "tests/formats/reading.hpp"

namespace keyblock::formats::dxf_layer_table_test {
namespace {

std::string line(const std::string& layer, int y) {
  const std::string height = std::to_string(y);
  return "0\nLINE\n8\n" + layer + "\n10\n0\n20\n" + height + "\n11\n9\n21\n" + height + "\n";
}

LayerTable table_of(const std::string& rows) {
  return read({"layers.csv", "layer,part\n" + rows}).content.layers;
}

Reading drawn(const std::string& entities, const std::string& rows) {
  ReadHint hint;
  hint.layers = table_of(rows);
  return read({"f", dxf_text(entities)}, hint);
}

std::string error_of_table(const std::string& rows) {
  return error_of("layer,part\n" + rows);
}

}  // namespace

TEST(DxfLayerTable, layers_are_what_the_table_says_whatever_their_case) {
  const std::string entities = line("Contour", 0) + line("BEDDING", 1) + line("Title", 2) + line("support", 3) +
                               line("Tunnel", 4) + "0\nPOINT\n8\nGauge\n10\n1\n20\n1\n";
  const Reading reading = drawn(entities,
                                "contour,outline\n# no part\nBedding,joint 3\nTitle,ignored\nSupport,fixed\n"
                                "Tunnel,Material 2\nGauge,measured\n");
  const Drawing& drawing = *reading.content.drawing;
  ASSERT_EQ(drawing.joints.size(), 2u);
  EXPECT_EQ(drawing.boundary_count, 1u);
  EXPECT_EQ(drawing.joints[0].segment.start.y, 0);
  EXPECT_EQ(drawing.joints[1].segment.start.y, 1);
  EXPECT_EQ(drawing.joints[1].joint_material, 2);
  ASSERT_EQ(drawing.fixed_lines.size(), 1u);
  EXPECT_EQ(drawing.fixed_lines[0].segment.start.y, 3);
  ASSERT_EQ(drawing.material_lines.size(), 1u);
  EXPECT_EQ(drawing.material_lines[0].block_material, 1);
  EXPECT_EQ(drawing.measured_points.size(), 1u);
  for (const Warning& warning : reading.warnings) EXPECT_NE(warning.name, "dxf_layer_as_joints") << warning.sentence;
}

// The sides of an outline of blocks lie on the layers of their vertices.
TEST(DxfLayerTable, sides_of_blocks_are_what_the_table_says) {
  std::string entities = "0\nPOLYLINE\n8\nBLOCK_1\n66\n1\n70\n1\n";
  for (const char* vertex : {"Bedding\n10\n0\n20\n0", "Bedding\n10\n2\n20\n0", "JOINT_4\n10\n2\n20\n2"})
    entities += std::string("0\nVERTEX\n8\n") + vertex + "\n";
  const Reading reading = drawn(entities + "0\nSEQEND\n", "Bedding,joint 2\n");
  const Drawing& drawing = *reading.content.drawing;
  ASSERT_EQ(drawing.joints.size(), 3u);
  EXPECT_EQ(drawing.joints[0].joint_material, 1);
  EXPECT_EQ(drawing.joints[1].joint_material, 1);
  EXPECT_EQ(drawing.joints[2].joint_material, 3);
}

TEST(DxfLayerTable, a_table_overrules_names_and_a_star_stands_for_all_others) {
  const std::string entities = line("JOINT_2", 0) + line("FIXED", 1) + line("x", 2) + line("y", 3);
  const Reading reading = drawn(entities, "joint_2,joint 5\n*,ignored\n");
  const Drawing& drawing = *reading.content.drawing;
  ASSERT_EQ(drawing.joints.size(), 1u) << "x and y are ignored";
  EXPECT_EQ(drawing.joints[0].joint_material, 4);
  EXPECT_EQ(drawing.fixed_lines.size(), 1u) << "its own name says it";
}

TEST(DxfLayerTable, old_marks_are_read_on_layers_that_the_table_does_not_name) {
  const std::string mark = "0\nTEXT\n8\nmarks\n10\n1\n20\n1\n40\n1\n1\nF\n";
  EXPECT_EQ(drawn(line("a", 0) + mark, "b,fixed\n").content.drawing->fixed_lines.size(), 1u);
  EXPECT_EQ(drawn(line("a", 0) + mark, "marks,ignored\na,joint 1\n").content.drawing->fixed_lines.size(), 0u);
}

TEST(DxfLayerTable, a_layer_on_which_nothing_lies_is_told) {
  const Reading reading = drawn(line("a", 0), "a,joint 1\nBeding,joint 2\n");
  const auto told = std::ranges::find(reading.warnings, "dxf_layer_not_there", &Warning::name);
  ASSERT_NE(told, reading.warnings.end());
  EXPECT_EQ(to_string(*told).substr(0, 14), "layers.csv:3:1");
  EXPECT_NE(told->sentence.find("\"Beding\""), std::string::npos);
}

TEST(DxfLayerTable, a_layer_of_nothing_but_texts_is_there) {
  const std::string text = "0\nTEXT\n8\nTitle\n10\n1\n20\n1\n40\n1\n1\nslope 3\n";
  const Reading reading = drawn(line("a", 0) + text, "a,joint 1\nTitle,ignored\n");
  for (const Warning& warning : reading.warnings) EXPECT_NE(warning.name, "dxf_layer_not_there") << warning.sentence;
}

TEST(DxfLayerTable, names_with_commas_stand_in_quotes) {
  const LayerTable table = table_of("\"a, \"\"b\"\"\",fixed\n");
  ASSERT_EQ(table.rows.size(), 1u);
  EXPECT_EQ(table.rows[0].first, "a, \"b\"");
}

TEST(DxfLayerTable, wrong_rows_are_one_error_at_their_line) {
  EXPECT_EQ(
      error_of_table("a,joint 2\nb,jiont 2\n"),
      "f:3:1: error: expected a part for layer \"b\": boundary, joint N, material N, bolt N, block N, fixed, load, "
      "measured, hole or ignored, found \"jiont 2\"; did you mean \"joint\"?");
  for (const char* part : {"", "joint 0", "joint -1", "joint 1.5", "joint x", "fixed 2", "joint 1 2", "boundaries"})
    EXPECT_NE(error_of_table(std::string("a,") + part + "\n").find("f:2:1: error: expected a part for layer \"a\""),
              std::string::npos)
        << part;
  EXPECT_EQ(error_of_table("a,fixed\n\nA,hole\n"), "f:4:1: error: expected each layer once, found \"A\" again");
  EXPECT_EQ(error_of_table("only a name\n"), "f:2:1: error: expected a row \"layer,part\", found \"only a name\"");
  EXPECT_EQ(error_of_table(",fixed\n"), "f:2:1: error: expected the name of a layer, found none");
  EXPECT_EQ(error_of_table("\n"), "f: error: expected rows \"layer,part\" behind the first line, found none");
}

}  // namespace keyblock::formats::dxf_layer_table_test
