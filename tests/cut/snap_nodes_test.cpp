// Nodes near a line move to the foot of the perpendicular on the nearest one; all others stay.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/mesh/snap_nodes.hpp"

#include <gtest/gtest.h>

namespace keyblock::snap_nodes_test {

TEST(SnapNodes, go_to_the_nearest_point_of_the_nearest_piece) {
  BodyGraph graph;
  graph.nodes = {{0, 0}, {4, 0}, {0, 0.1}, {4, 0.1}};
  graph.pieces = {{.from = 0, .to = 1}, {.from = 2, .to = 3}};
  TriangleMesh mesh;
  mesh.nodes = {{1, 0.02}, {2, 0.07}, {3, -0.06}, {4.03, 0.0}, {1, 0.05}};
  EXPECT_EQ(snap_nodes(mesh, graph, 0.05), 3);
  EXPECT_EQ(mesh.nodes[0], (Point{1, 0}));
  EXPECT_EQ(mesh.nodes[1], (Point{2, 0.1}));
  EXPECT_EQ(mesh.nodes[2], (Point{3, -0.06})) << "farther than the reach";
  EXPECT_EQ(mesh.nodes[3], (Point{4, 0})) << "an end";
  EXPECT_EQ(mesh.nodes[4], (Point{1, 0.05})) << "not nearer than the reach";
}

}  // namespace keyblock::snap_nodes_test
