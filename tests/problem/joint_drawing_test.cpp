// Traces are clipped to the inside of the outline and the outside of tunnels, and the drawing cuts into blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/joints/joint_drawing.hpp"

#include <gtest/gtest.h>

#include "cut/bodies/cut_blocks.hpp"
#include "geometry/polygon.hpp"

namespace keyblock::joint_drawing_test {
namespace {

const Outline kSquare{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
const Outline kHole{{4, 4}, {6, 4}, {6, 6}, {4, 6}};

double length_of(const std::vector<Segment>& pieces) {
  double sum = 0;
  for (const Segment& piece : pieces) sum += distance(piece.start, piece.end);
  return sum;
}

JointSet through_going(double dip_deg, double spacing, int material) {
  JointSet set;
  set.dip_deg = dip_deg;
  set.spacing.mean = spacing;
  set.joint_material = material;
  set.seed = 5;
  set.stream = static_cast<std::uint64_t>(material);
  return set;
}

double area_of(const Blocks& blocks) {
  double sum = 0;
  for (const BlockPolygon& block : blocks.blocks) {
    sum += area(points_of(block.outer));
    for (const BlockLoop& hole : block.holes) sum += area(points_of(hole));
  }
  return sum;
}

}  // namespace

TEST(JointDrawing, segments_are_clipped_to_the_outline_without_the_holes) {
  const std::vector<Outline> loops{kSquare, kHole};
  EXPECT_EQ(clipped({{-5, 5}, {15, 5}}, loops), (std::vector<Segment>{{{0, 5}, {4, 5}}, {{6, 5}, {10, 5}}}));
  EXPECT_EQ(clipped({{1, 1}, {3, 2}}, loops), (std::vector<Segment>{{{1, 1}, {3, 2}}}));
  EXPECT_TRUE(clipped({{4.5, 5}, {5.5, 5}}, loops).empty());
  EXPECT_TRUE(clipped({{11, 0}, {11, 9}}, loops).empty());
  EXPECT_TRUE(clipped({{-1, 0}, {11, 0}}, loops).empty()) << "along the outline";
  EXPECT_NEAR(length_of(clipped({{-1, -1}, {11, 11}}, loops)), 8 * std::sqrt(2.0), 1e-12) << "through corners";
  EXPECT_NEAR(length_of(clipped({{2, 4}, {4, 6}}, loops)), std::sqrt(8.0), 1e-12) << "ending at a corner";
  EXPECT_EQ(clipped({{3, 5}, {5, 3}}, loops).size(), 1u) << "touching a corner of the hole";
}

TEST(JointDrawing, a_grid_of_joints_cuts_the_outline_into_all_its_blocks) {
  JointScene scene;
  scene.outline = RectangleShape{0, 0, 10, 6};
  scene.sets = {through_going(0, 2, 1), through_going(90, 2, 2)};
  scene.edge_node_ratio = 0.001;
  const Drawing drawing = drawing_of(scene);
  EXPECT_EQ(drawing.boundary_count, 4u);
  ASSERT_EQ(drawing.joints.size(), 4u + 3 + 5);
  const Blocks blocks = cut_blocks(drawing).blocks;
  EXPECT_EQ(blocks.blocks.size(), 4u * 6);
  EXPECT_NEAR(area_of(blocks), 60, 1e-9);
}

TEST(JointDrawing, tunnels_stay_open_when_cut) {
  JointScene scene;
  scene.outline = SlopeShape{0, 0, 10, 60, 2, 2, 10, 15, 10};
  scene.tunnels = {{TunnelShape::circle, 2, -5, 4, 4, {}}, {TunnelShape::d, 12, -5, 4, 4, {}}};
  scene.sets = {through_going(20, 1.5, 1), through_going(105, 2, 2)};
  scene.sets[0].trace_length = RandomLength{6, 0.3, Distribution::exponential};
  scene.sets[0].gap = {0.5, 0.3, Distribution::lognormal};
  scene.edge_node_ratio = 0.001;
  const Drawing drawing = drawing_of(scene);
  EXPECT_EQ(drawing.hole_points.size(), 2u);
  const CutResult cut = cut_blocks(drawing);
  EXPECT_GT(cut.blocks.blocks.size(), 50u);
  const double expected = area(outline_of(std::get<SlopeShape>(scene.outline))) - area(outline_of(scene.tunnels[0])) -
                          area(outline_of(scene.tunnels[1]));
  EXPECT_NEAR(area_of(cut.blocks), expected, 1e-3 * expected) << "crossings move by less than the merging distance";
}

TEST(JointDrawing, one_set_more_changes_none_of_the_others) {
  JointScene scene;
  scene.outline = RectangleShape{0, 0, 30, 30};
  scene.sets = {through_going(40, 2, 1)};
  scene.sets[0].spacing.scatter = 0.5;
  const Drawing one = drawing_of(scene);
  scene.sets.push_back(through_going(100, 3, 2));
  const Drawing two = drawing_of(scene);
  ASSERT_GT(two.joints.size(), one.joints.size());
  for (std::size_t i = 0; i < one.joints.size(); ++i) EXPECT_EQ(two.joints[i].segment, one.joints[i].segment);
}

TEST(JointDrawing, tunnels_that_leave_the_outline_or_meet_are_refused) {
  JointScene scene;
  scene.outline = RectangleShape{0, 0, 10, 10};
  for (const std::vector<TunnelSection>& tunnels :
       {std::vector<TunnelSection>{{TunnelShape::circle, 9, 5, 4, 4, {}}},
        {{TunnelShape::circle, 20, 5, 4, 4, {}}},
        {{TunnelShape::circle, 5, 5, 4, 4, {}}, {TunnelShape::d, 6, 5, 4, 4, {}}},
        {{TunnelShape::circle, 5, 5, 6, 6, {}}, {TunnelShape::d, 5, 5, 1, 1, {}}},
        {{TunnelShape::d, 5, 5, 1, 1, {}}, {TunnelShape::circle, 5, 5, 6, 6, {}}}}) {
    scene.tunnels = tunnels;
    EXPECT_THROW(drawing_of(scene), InputError);
  }
}

}  // namespace keyblock::joint_drawing_test
