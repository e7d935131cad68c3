// Faces lie to the left of their chains, in the order of Shi's programs, with their holes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/lines/faces.hpp"

#include <gtest/gtest.h>

#include "geometry/polygon.hpp"
#include "tests/cut/arrangements.hpp"

namespace keyblock::faces_test {
namespace {

std::vector<int> nodes_of(const Chain& chain) {
  std::vector<int> nodes;
  for (const ChainLink& link : chain) nodes.push_back(link.node);
  return nodes;
}

std::vector<int> lines_of(const Chain& chain) {
  std::vector<int> lines;
  for (const ChainLink& link : chain) lines.push_back(link.line);
  return lines;
}

double signed_area(const Arrangement& a, const Chain& chain) {
  std::vector<Point> points;
  for (const ChainLink& link : chain) points.push_back(a.nodes[link.node].position);
  return area(points);
}

using Ends = std::vector<std::pair<int, int>>;

const std::vector<Point> kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const Ends kRing{{0, 1}, {1, 2}, {2, 3}, {3, 0}};

}  // namespace

TEST(Faces, a_ring_is_one_face_from_its_lowest_node_with_the_arriving_lines) {
  const Arrangement a = arrangement_of({{4, 4}, {0, 4}, {0, 0}, {4, 0}}, kRing);
  const std::vector<Face> faces = trace_faces(a);
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_EQ(nodes_of(faces[0].outer), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(lines_of(faces[0].outer), (std::vector<int>{3, 0, 1, 2}));
  EXPECT_TRUE(faces[0].holes.empty());
}

// About node 0 counter-clockwise from x come the edges to 1, then 3: each opens the face to its right. To the right of
// 0 → 1 is the outside, to the right of the diagonal the lower half, of 0 → 3 the upper one.
TEST(Faces, are_numbered_by_the_edges_about_the_lowest_nodes) {
  Ends ends = kRing;
  ends.push_back({2, 0});
  const std::vector<Face> faces = trace_faces(arrangement_of(kSquare, ends));
  ASSERT_EQ(faces.size(), 2U);
  EXPECT_EQ(nodes_of(faces[0].outer), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(nodes_of(faces[1].outer), (std::vector<int>{0, 2, 3}));
}

TEST(Faces, a_ring_within_a_ring_is_a_face_and_a_hole_of_the_other) {
  std::vector<Point> nodes = kSquare;
  nodes.insert(nodes.end(), {{1, 1}, {2, 1}, {2, 2}, {1, 2}});
  Ends ends = kRing;
  for (const auto& [from, to] : kRing) ends.push_back({from + 4, to + 4});
  const Arrangement a = arrangement_of(nodes, ends);
  const std::vector<Face> faces = trace_faces(a);
  ASSERT_EQ(faces.size(), 2U);
  ASSERT_EQ(faces[0].holes.size(), 1U);
  EXPECT_EQ(signed_area(a, faces[0].outer), 16);
  EXPECT_EQ(signed_area(a, faces[0].holes[0]), -1) << "clockwise";
  EXPECT_EQ(signed_area(a, faces[1].outer), 1);
  EXPECT_TRUE(faces[1].holes.empty());
}

// Ring 8 … 11 is in the hole's island: a hole of the island, not of the outermost ring.
TEST(Faces, an_island_within_an_island_is_a_hole_of_the_nearest) {
  std::vector<Point> nodes = {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {1, 1}, {8, 1},
                              {8, 8}, {1, 8}, {3, 3}, {4, 3}, {4, 4}, {3, 4}};
  Ends ends;
  for (int ring : {0, 4, 8})
    for (const auto& [from, to] : kRing) ends.push_back({from + ring, to + ring});
  const Arrangement a = arrangement_of(nodes, ends);
  const std::vector<Face> faces = trace_faces(a);
  ASSERT_EQ(faces.size(), 3U);
  ASSERT_EQ(faces[0].holes.size(), 1U);
  EXPECT_EQ(signed_area(a, faces[0].holes[0]), -49);
  ASSERT_EQ(faces[1].holes.size(), 1U);
  EXPECT_EQ(signed_area(a, faces[1].holes[0]), -1);
}

TEST(Faces, a_loop_that_touches_the_outer_chain_in_a_node_is_a_chain_of_its_own) {
  std::vector<Point> nodes = kSquare;
  nodes.insert(nodes.end(), {{2, 1}, {1, 2}});
  Ends ends = kRing;
  ends.insert(ends.end(), {{0, 4}, {4, 5}, {5, 0}});
  const Arrangement a = arrangement_of(nodes, ends);
  const std::vector<Face> faces = trace_faces(a);
  ASSERT_EQ(faces.size(), 2U);
  const Face& around = faces[0].holes.empty() ? faces[1] : faces[0];
  const Face& within = faces[0].holes.empty() ? faces[0] : faces[1];
  EXPECT_EQ(signed_area(a, around.outer), 16);
  ASSERT_EQ(around.holes.size(), 1U);
  EXPECT_EQ(signed_area(a, around.holes[0]), -1.5);
  EXPECT_EQ(signed_area(a, within.outer), 1.5);
}

TEST(Faces, without_edges_there_are_none) {
  EXPECT_TRUE(trace_faces({}).empty());
}

}  // namespace keyblock::faces_test
