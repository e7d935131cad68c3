// DXF: an INSERT draws its block in its place, and the plane of a drawing is that of most entities.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>

#include "tests/formats/dxf_samples.hpp"

namespace keyblock::formats::dxf_inserts_test {

// A block of a unit square on layer 0 with a joint of its own layer, base point in its middle. The majority of shapes
// decides; tilted ones lie in no plane.
TEST(DxfInserts, the_plane_is_that_of_most_entities) {
  const std::string at = "30\n412.5\n31\n412.5\n";
  const Reading reading = read_entities(dxf_line("JOINT_1", at) + dxf_line("JOINT_2", at) + dxf_line("JOINT_3"));
  ASSERT_EQ(reading.content.drawing->joints.size(), 2U);
  EXPECT_NE(sentence(reading, "dxf_skipped").find("1 × LINE not in the plane z = 412.5"), std::string::npos);
  const Reading below =
      read_entities(dxf_circle("30\n-7\n210\n0\n220\n0\n230\n-1\n") + dxf_line("JOINT_1", "30\n7\n31\n7\n"));
  EXPECT_EQ(below.content.drawing->joints.size(), 33U) << "the height of a circle counts along its normal";
}

TEST(DxfInserts, an_insert_lifts_what_it_draws) {
  const std::string block = "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nbar\n10\n0\n20\n0\n30\n2\n" +
                            dxf_line("JOINT_1", "30\n5\n31\n5\n") + "0\nENDBLK\n0\nENDSEC\n";
  std::string text =
      dxf_text("0\nINSERT\n8\n0\n2\nbar\n10\n0\n20\n0\n30\n100\n43\n2\n" + dxf_line("JOINT_2", "30\n106\n31\n106\n"));
  text.insert(text.find("0\nSECTION\n2\nENTITIES"), block);
  EXPECT_EQ(read({"f", text}).content.drawing->joints.size(), 2U) << "100 + 2 (5 - 2) = 106";
}

TEST(DxfInserts, an_invisible_entity_is_skipped_and_said) {
  const Reading reading = read_entities(dxf_line("JOINT_1") + dxf_line("JOINT_1", "60\n1\n"));
  EXPECT_EQ(reading.content.drawing->joints.size(), 1U);
  EXPECT_NE(sentence(reading, "dxf_skipped").find("1 × LINE that is invisible"), std::string::npos);
}

TEST(DxfInserts, an_insert_in_rows_and_columns_draws_its_block_at_each) {
  const std::string block =
      "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nbar\n10\n0\n20\n0\n0\nLINE\n8\nJOINT_1\n10\n0\n20\n0\n11\n1\n21\n0\n"
      "0\nENDBLK\n0\nENDSEC\n";
  std::string text = dxf_text("0\nINSERT\n8\n0\n2\nbar\n10\n5\n20\n7\n41\n3\n50\n90\n70\n2\n71\n3\n44\n10\n45\n20\n");
  text.insert(text.find("0\nSECTION\n2\nENTITIES"), block);
  const std::vector<JointLine> joints = read({"f", text}).content.drawing->joints;
  ASSERT_EQ(joints.size(), 6U);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 2; ++column) {  // rotated by 90 degrees: columns go up, rows to the left
      const Segment& found = joints[static_cast<std::size_t>(2 * row + column)].segment;
      EXPECT_LT(distance(found.start, {5.0 - 20 * row, 7.0 + 10 * column}), 1e-12);
      EXPECT_LT(distance(found.end, {5.0 - 20 * row, 10.0 + 10 * column}), 1e-12)
          << "three times as long, not three times as far";
    }
  text.replace(text.find("70\n2"), 4, "70\n2000000000");
  EXPECT_THROW(read({"f", text}), InputError);
}

TEST(DxfInserts, an_insert_draws_its_block_scaled_turned_and_on_its_own_layer) {
  std::string text = dxf_text(
      "0\nINSERT\n8\nBOUNDARY_2\n2\nhouse\n10\n10\n20\n20\n41\n4\n42\n2\n50\n90\n"
      "0\nINSERT\n8\n0\n2\nnone\n10\n0\n20\n0\n");
  text.insert(text.find("0\nSECTION\n2\nENTITIES"),
              "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n8\n0\n2\nhouse\n10\n0.5\n20\n0.5\n"
              "0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n10\n0\n20\n0\n10\n1\n20\n0\n10\n1\n20\n1\n10\n0\n20\n1\n"
              "0\nLINE\n8\nJOINT_3\n10\n0\n20\n0.5\n11\n1\n21\n0.5\n0\nENDBLK\n0\nENDSEC\n");
  const Reading reading = read({"f", text});
  const Drawing& drawing = *reading.content.drawing;
  ASSERT_EQ(drawing.boundary_count, 4U);
  ASSERT_EQ(drawing.joints.size(), 5U);
  EXPECT_EQ(drawing.joints[0].joint_material, 1);
  EXPECT_EQ(drawing.joints[4].joint_material, 2);
  // (-0.5, -0.5) by (4, 2), rotated by 90 degrees: (1, -2) from (10, 20).
  EXPECT_NEAR(drawing.joints[0].segment.start.x, 11, 1e-12);
  EXPECT_NEAR(drawing.joints[0].segment.start.y, 18, 1e-12);
  EXPECT_NEAR(drawing.joints[4].segment.start.x, 10, 1e-12);
  EXPECT_NEAR(drawing.joints[4].segment.start.y, 18, 1e-12);
  EXPECT_NEAR(drawing.joints[4].segment.end.y, 22, 1e-12);
  EXPECT_NE(sentence(reading, "dxf_skipped").find("INSERT of a block that is not there"), std::string::npos);
}

TEST(DxfInserts, a_block_that_holds_itself_is_refused_at_its_insert) {
  std::string text = dxf_text("0\nINSERT\n8\n0\n2\na\n10\n0\n20\n0\n");
  text.insert(text.find("0\nSECTION\n2\nENTITIES"),
              "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\na\n0\nINSERT\n8\n0\n2\na\n10\n0\n20\n0\n0\nENDBLK\n0\nENDSEC\n");
  EXPECT_THROW(read({"f", text}), InputError);
}

// Each of 16 blocks draws the next one ten times.
TEST(DxfInserts, blocks_that_would_draw_without_end_are_refused) {
  std::string blocks;
  for (int i = 0; i < 12; ++i) {
    blocks += "0\nBLOCK\n2\nb" + std::to_string(i) + "\n";
    for (int k = 0; k < 10; ++k)
      blocks += i == 11 ? dxf_line("JOINT_1") : "0\nINSERT\n8\n0\n2\nb" + std::to_string(i + 1) + "\n10\n0\n20\n0\n";
    blocks += "0\nENDBLK\n";
  }
  std::string text = dxf_text("0\nINSERT\n8\n0\n2\nb0\n10\n0\n20\n0\n");
  text.insert(text.find("0\nSECTION\n2\nENTITIES"), "0\nSECTION\n2\nBLOCKS\n" + blocks + "0\nENDSEC\n");
  EXPECT_THROW(read({"f", text}), InputError);
}

}  // namespace keyblock::formats::dxf_inserts_test
