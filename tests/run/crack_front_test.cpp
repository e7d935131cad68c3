// Propagation of cracks: tips of joints and cracks that start, in one step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/growth/crack_front.hpp"

#include <gtest/gtest.h>

#include "cut/bodies/cut_blocks.hpp"
#include "cut/covers/cut_cover.hpp"
#include "cut/mesh/background_mesh.hpp"
#include "geometry/box.hpp"
#include "tests/cut/drawings.hpp"

namespace keyblock::crack_front_test {
namespace {

// A square of side 2 about the origin with a joint from its left side that ends at (-0.5, 0).
Manifold square_with_joint() {
  Box box;
  box.add({-1.1, -1.1});
  box.add({1.1, 1.1});
  RegularMesh mesh = centred_mesh(box, 4, MeshShape::equilateral);
  mesh.angle = 0.1;
  const Drawing drawing = drawing_of(rectangle_sides({-1, -1}, {1, 1}) + std::vector<Segment>{{{-1, 0}, {-0.5, 0}}});
  return cut_cover(cut_bodies(drawing).graph, regular_triangles(box, mesh));
}

}  // namespace

// The joint is crack 1 until a crack of its own begins at its tip; a crack that starts meanwhile follows it in the
// list.
TEST(CrackFront, a_joint_goes_on_while_a_crack_starts) {
  const Manifold manifold = square_with_joint();
  ASSERT_EQ(manifold.tips.size(), 1U);
  TipState tip;
  tip.crack = 0;
  tip.at_end = true;
  tip.at = manifold.tips.front().at;
  tip.goes_on = true;
  CrackStart start;
  start.at = {0.5, 0.5};
  start.along = {0, 1};
  start.half_length = 0.1;
  const std::vector<CrackPlan> cracks = prolonged({{}, {tip}, {start}}, manifold, 0.2, {0});
  ASSERT_EQ(cracks.size(), 2U);
  ASSERT_EQ(cracks[0].along.size(), 2U);
  EXPECT_EQ(cracks[0].along[0], tip.at);
  EXPECT_NEAR(distance(cracks[0].along[1], {-0.3, 0}), 0, 1e-12);
  ASSERT_EQ(cracks[1].along.size(), 2U);
  EXPECT_NEAR(distance(cracks[1].along[0], {0.5, 0.4}), 0, 1e-12);
  EXPECT_NEAR(distance(cracks[1].along[1], {0.5, 0.6}), 0, 1e-12);
}

}  // namespace keyblock::crack_front_test
