// Graded meshes by bisection: conforming, of the same area, of sound angles, as fine as requested, and nested.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/mesh/bisect_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "cut/mesh/background_mesh.hpp"
#include "geometry/polygon.hpp"

namespace keyblock::bisect_mesh_test {
namespace {

constexpr double kAngle = 10 * std::numbers::pi / 180;

TriangleMesh turned_mesh() {
  Box box;
  box.add({0, 0});
  box.add({4, 3});
  return regular_triangles(box, {1, std::sqrt(3.0) / 2, {0.13, 0.27}, kAngle});
}

std::array<Point, 3> corners(const TriangleMesh& mesh, const std::array<int, 3>& t) {
  return {mesh.nodes[static_cast<std::size_t>(t[0])], mesh.nodes[static_cast<std::size_t>(t[1])],
          mesh.nodes[static_cast<std::size_t>(t[2])]};
}

double area_of(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) sum += area(corners(mesh, t));
  return sum;
}

double least_angle(const TriangleMesh& mesh) {
  double least = 180;
  for (const auto& t : mesh.triangles) {
    const auto p = corners(mesh, t);
    for (std::size_t k = 0; k < 3; ++k) {
      const Point a = p[(k + 1) % 3] - p[k], b = p[(k + 2) % 3] - p[k];
      least = std::min(least, std::atan2(cross(a, b), dot(a, b)) * 180 / std::numbers::pi);
    }
  }
  return least;
}

/// Size of the triangles that hold a point.
double longest_side_at(const TriangleMesh& mesh, const std::vector<Point>& points) {
  double longest = 0;
  for (const auto& t : mesh.triangles) {
    const auto p = corners(mesh, t);
    if (std::ranges::none_of(points, [&](Point at) { return side(p, at) != Side::outside; })) continue;
    for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, distance(p[k], p[(k + 1) % 3]));
  }
  return longest;
}

/// Counts every directed side: a side between two triangles occurs once in each direction.
bool is_conforming(const TriangleMesh& mesh, std::size_t boundary_sides) {
  std::map<std::pair<int, int>, int> sides;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
  std::size_t single = 0;
  for (const auto& [side, count] : sides) {
    if (count != 1) return false;
    if (!sides.contains({side.second, side.first})) ++single;
  }
  return boundary_sides == 0 || single == boundary_sides;
}

TEST(BisectMesh, is_fine_at_points_conforming_and_sound) {
  TriangleMesh mesh = turned_mesh();
  const double before = area_of(mesh);
  const std::size_t triangles = mesh.triangles.size();
  const Point at{1.234, 1.987};
  const MeshSize size(std::numeric_limits<double>::infinity(), {{at, 1e-3}}, 0.5);
  const int added = bisect(mesh, size, {std::cos(kAngle), std::sin(kAngle)});
  EXPECT_GT(added, 200);
  EXPECT_LT(mesh.triangles.size(), triangles + 4000);
  EXPECT_NEAR(area_of(mesh), before, 1e-12 * before);
  EXPECT_TRUE(is_conforming(mesh, 0));
  EXPECT_GT(least_angle(mesh), 29.99);
  for (const auto& t : mesh.triangles) {
    const auto p = corners(mesh, t);
    const Point middle = (1.0 / 3) * (p[0] + p[1] + p[2]);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_LE(distance(p[k], p[(k + 1) % 3]), size.at(middle));
  }
}

TEST(BisectMesh, leaves_a_mesh_that_is_fine_enough) {
  TriangleMesh mesh = turned_mesh();
  const TriangleMesh before = mesh;
  EXPECT_EQ(bisect(mesh, {2, {}, 0.5}, {1, 0}), 0);
  EXPECT_EQ(mesh.nodes, before.nodes);
}

TEST(BisectMesh, gives_points_nodes_without_bad_triangles) {
  for (int i = 0; i < 200; ++i) {
    TriangleMesh mesh = turned_mesh();
    const std::size_t triangles = mesh.triangles.size();
    const double before = area_of(mesh);
    const std::vector<Point> points{{0.5 + 0.013 * i, 1 + 0.0071 * i}, {3.5, 0.3 + 0.002 * i}};
    ASSERT_EQ(place_nodes(mesh, points), 2) << i;
    for (const Point p : points) EXPECT_NE(std::ranges::find(mesh.nodes, p), mesh.nodes.end());
    EXPECT_EQ(mesh.triangles.size(), triangles);
    EXPECT_NEAR(area_of(mesh), before, 1e-12 * before);
    EXPECT_GT(least_angle(mesh), 15) << i;
  }
}

TEST(BisectMesh, halves_what_holds_a_point_until_its_longest_side_is_as_short_as_asked_for) {
  for (int i = 0; i < 50; ++i) {
    TriangleMesh mesh = turned_mesh();
    const double before = area_of(mesh);
    const std::vector<Point> points{{0.5 + 0.013 * i, 1 + 0.0071 * i}, {3.5, 0.3 + 0.002 * i}};
    if (i % 2 == 0) place_nodes(mesh, points);
    const double longest = 0.1 + 0.01 * i;
    bisect_at(mesh, points, longest, {std::cos(kAngle), std::sin(kAngle)});
    EXPECT_NEAR(area_of(mesh), before, 1e-12 * before);
    EXPECT_TRUE(is_conforming(mesh, 0));
    EXPECT_GT(least_angle(mesh), 10) << i;
    EXPECT_LE(longest_side_at(mesh, points), longest * (1 + 1e-9)) << i;
  }
}

}  // namespace
}  // namespace keyblock::bisect_mesh_test
