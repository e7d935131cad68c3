// The regular mesh covers its box with equal triangles, and its density follows the rule of Shi's cutter.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/mesh/background_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/polygon.hpp"

namespace keyblock::background_mesh_test {
namespace {

std::vector<Point> corners(const TriangleMesh& mesh, const std::array<int, 3>& t) {
  return {mesh.nodes[t[0]], mesh.nodes[t[1]], mesh.nodes[t[2]]};
}

bool holds(const TriangleMesh& mesh, Point p) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [&](const auto& t) { return side(corners(mesh, t), p) != Side::outside; });
}

bool has_node(const TriangleMesh& mesh, Point p) {
  return std::any_of(mesh.nodes.begin(), mesh.nodes.end(), [&](Point q) { return distance(p, q) < 1e-12; });
}

const Box kBox{{-1, 2}, {3, 5}};

}  // namespace

TEST(BackgroundMesh, covers_its_box_with_equal_triangles_at_any_angle) {
  for (const double angle : {0.0, 0.1, 1.0, -2.5}) {
    RegularMesh mesh = centred_mesh(kBox, 3, MeshShape::old);
    mesh.angle = angle;
    const TriangleMesh triangles = regular_triangles(kBox, mesh);
    for (const auto& t : triangles.triangles) EXPECT_NEAR(area(corners(triangles, t)), mesh.dx * mesh.dy / 2, 1e-13);
    for (int i = 0; i <= 20; ++i)
      for (int j = 0; j <= 20; ++j) EXPECT_TRUE(holds(triangles, {-1 + i * 0.2, 2 + j * 0.15})) << angle;
  }
}

TEST(BackgroundMesh, equilateral_triangles_have_three_equal_sides) {
  const TriangleMesh mesh = regular_triangles(kBox, centred_mesh(kBox, 4, MeshShape::equilateral));
  for (const auto& t : mesh.triangles) {
    const auto p = corners(mesh, t);
    EXPECT_NEAR(distance(p[0], p[1]), distance(p[1], p[2]), 1e-13);
    EXPECT_NEAR(distance(p[1], p[2]), distance(p[2], p[0]), 1e-13);
  }
}

// w = max(3/2, 4/2.6): 1.538…; n = 2: dy = 1.1 w/2, dx = 1.3 dy, the rows n = ±2 have a node at the middle.
TEST(BackgroundMesh, old_density_rule_places_rows_about_the_middle) {
  const double w = 4 / 2.6;
  const RegularMesh mesh = centred_mesh(kBox, 2, MeshShape::old);
  EXPECT_DOUBLE_EQ(mesh.dy, 1.1 * w / 2);
  EXPECT_DOUBLE_EQ(mesh.dx, 1.3 * 1.1 * w / 2);
  const TriangleMesh triangles = regular_triangles(kBox, mesh);
  EXPECT_TRUE(has_node(triangles, {1, 3.5}));
  EXPECT_TRUE(has_node(triangles, {1 + mesh.dx / 2, 3.5 + mesh.dy}));
  const RegularMesh odd = centred_mesh(kBox, 3, MeshShape::old);
  EXPECT_FALSE(has_node(regular_triangles(kBox, odd), {1, 3.5}));
  EXPECT_TRUE(has_node(regular_triangles(kBox, odd), {1, 3.5 + odd.dy})) << "row 1 has the parity of n = 3";
}

TEST(BackgroundMesh, an_aligned_mesh_has_rows_on_both_edges_of_the_box) {
  const RegularMesh mesh = aligned_mesh(kBox, 2, MeshShape::equilateral);
  EXPECT_DOUBLE_EQ(mesh.dy, 0.75);
  EXPECT_TRUE(has_node(regular_triangles(kBox, mesh), {-1, 2}));
  EXPECT_TRUE(has_node(regular_triangles(kBox, mesh), {-1, 5}));
}

TEST(BackgroundMesh, nodes_are_numbered_row_by_row_from_the_left) {
  const TriangleMesh mesh = regular_triangles(kBox, centred_mesh(kBox, 3, MeshShape::old));
  for (std::size_t i = 1; i < mesh.nodes.size(); ++i) {
    const Point a = mesh.nodes[i - 1];
    const Point b = mesh.nodes[i];
    EXPECT_TRUE(b.y > a.y + 0.1 || (std::fabs(b.y - a.y) < 1e-12 && b.x > a.x));
  }
}

}  // namespace keyblock::background_mesh_test
