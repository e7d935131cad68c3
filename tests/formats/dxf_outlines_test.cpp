// DXF: joints end at the boundary of a drawing, and outlines of blocks are cut to these blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cut/bodies/cut_blocks.hpp"
#include "geometry/polygon.hpp"
#include "tests/formats/dxf_samples.hpp"

namespace keyblock::formats::dxf_outlines_test {

namespace {

/// x, y of a corner and the joint material, from 1, of the side that begins there.
struct Corner {
  int x, y, joint;
};

std::string outline(const std::string& layer, const std::vector<Corner>& corners) {
  std::string text = "0\nPOLYLINE\n8\n" + layer + "\n66\n1\n70\n1\n";
  for (const Corner& c : corners) text += fmt::format("0\nVERTEX\n8\nJOINT_{}\n10\n{}\n20\n{}\n", c.joint, c.x, c.y);
  return text + "0\nSEQEND\n";
}

/// Text of a drawing program: without the comment of Keyblock.
Reading drawn(const std::string& entities) {
  std::string text = dxf_text(entities);
  return read({"f", text.substr(text.find("0\nSECTION"))});
}

std::string straight(const std::string& layer, Point a, Point b) {
  return fmt::format("0\nLINE\n8\n{}\n10\n{}\n20\n{}\n11\n{}\n21\n{}\n", layer, a.x, a.y, b.x, b.y);
}

const std::string kSquareOutline = straight("BOUNDARY", {0, 0}, {4, 0}) + straight("BOUNDARY", {4, 4}, {4, 0}) +
                                   straight("BOUNDARY", {4, 4}, {0, 4}) + straight("BOUNDARY", {0, 4}, {0, 0});

}  // namespace

TEST(DxfOutlines, joints_beyond_the_boundary_are_cut_off_and_it_is_said) {
  const Reading reading = drawn(kSquareOutline + straight("JOINT_2", {-3, 1}, {7, 1}) +
                                straight("JOINT_3", {1, 1}, {3, 3}) + straight("JOINT_4", {5, 5}, {9, 5}));
  const Drawing& drawing = *reading.content.drawing;
  ASSERT_EQ(drawing.boundary_count, 4U);
  ASSERT_EQ(drawing.joints.size(), 6U);
  EXPECT_NEAR(drawing.joints[4].segment.start.x, 0, 1e-12);
  EXPECT_NEAR(drawing.joints[4].segment.end.x, 4, 1e-12);
  EXPECT_EQ(drawing.joints[4].joint_material, 1);
  EXPECT_EQ(drawing.joints[5].segment, (Segment{{1, 1}, {3, 3}})) << "to the last digit";
  EXPECT_NE(sentence(reading, "dxf_clipped").find("1 are shorter now or in pieces, 1 lay outside"), std::string::npos);
}

TEST(DxfOutlines, a_loop_with_a_hole_point_is_kept_free_of_joints_and_one_without_is_not) {
  const std::string inner =
      "0\nLWPOLYLINE\n8\nBOUNDARY\n90\n4\n70\n1\n10\n1\n20\n1\n10\n2\n20\n1\n10\n2\n20\n2\n"
      "10\n1\n20\n2\n";
  const std::string joint = straight("JOINT_2", {0, 1.5}, {4, 1.5});
  EXPECT_EQ(drawn(kSquareOutline + inner + joint).content.drawing->joints.size(), 9U);
  const Reading open = drawn(kSquareOutline + inner + joint + "0\nPOINT\n8\nHOLE\n10\n1.5\n20\n1.2\n");
  const Drawing& drawing = *open.content.drawing;
  ASSERT_EQ(drawing.joints.size(), 10U);
  EXPECT_NEAR(drawing.joints[8].segment.end.x, 1, 1e-12);
  EXPECT_NEAR(drawing.joints[9].segment.start.x, 2, 1e-12);
}

TEST(DxfOutlines, a_boundary_that_does_not_close_cuts_nothing_off_and_says_where) {
  const std::string open = straight("BOUNDARY", {0, 0}, {4, 0}) + straight("BOUNDARY", {4, 0}, {4, 4});
  const Reading reading = drawn(open + straight("JOINT_2", {-3, 1}, {7, 1}));
  EXPECT_EQ(reading.content.drawing->joints.back().segment.start.x, -3);
  EXPECT_NE(sentence(reading, "dxf_not_clipped"), "");
}

TEST(DxfOutlines, outlines_on_the_layers_of_blocks_cut_are_these_blocks) {
  const Reading again = read_entities(outline("BLOCK_1", {{0, 0, 1}, {2, 0, 3}, {2, 2, 1}, {0, 2, 1}}) +
                                      outline("BLOCK_2", {{2, 0, 1}, {4, 0, 2}, {4, 3, 1}, {2, 2, 3}}));
  const Blocks cut = cut_blocks(*again.content.drawing).blocks;
  ASSERT_EQ(cut.blocks.size(), 2u);
  for (const BlockPolygon& block : cut.blocks) {
    const bool is_left = block.material == 0;
    EXPECT_EQ(area(points_of(block.outer)), is_left ? 4 : 5);
    std::vector<int> joints;
    for (const BlockVertex& vertex : block.outer) joints.push_back(vertex.joint_material);
    std::ranges::sort(joints);
    EXPECT_EQ(joints, is_left ? (std::vector<int>{0, 0, 0, 2}) : (std::vector<int>{0, 0, 1, 2}));
  }
}

}  // namespace keyblock::formats::dxf_outlines_test
