// Unstructured meshes keep their size and their angles, are cut like regular ones, and follow lines if requested.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/mesh/unstructured_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cut/bodies/cut_blocks.hpp"
#include "cut/covers/cut_cover.hpp"
#include "cut/mesh/fit_mesh.hpp"
#include "tests/cut/drawings.hpp"
#include "tests/cut/manifolds.hpp"

namespace keyblock::unstructured_mesh_test {
namespace {

const Box kBox{{0, 0}, {4, 2}};

std::vector<Point> corners(const TriangleMesh& mesh, const std::array<int, 3>& t) {
  return {mesh.nodes[static_cast<std::size_t>(t[0])], mesh.nodes[static_cast<std::size_t>(t[1])],
          mesh.nodes[static_cast<std::size_t>(t[2])]};
}

double longest_side(const std::vector<Point>& t) {
  return std::max({distance(t[0], t[1]), distance(t[1], t[2]), distance(t[2], t[0])});
}

double total_area(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) sum += area(corners(mesh, t));
  return sum;
}

const MeshSize kGraded{0.4, {{{1, 1.3}, 0.02}, {{3.5, 0.5}, 0.05}}, 0.3};

}  // namespace

TEST(UnstructuredMesh, sides_are_no_longer_than_wanted_and_angles_no_sharper_than_20_degrees) {
  const TriangleMesh mesh = unstructured_mesh(kBox, kGraded);
  EXPECT_NEAR(total_area(mesh), 4.4 * 2.4, 1e-12);
  for (const auto& t : mesh.triangles) {
    const std::vector<Point> p = corners(mesh, t);
    EXPECT_LE(longest_side(p), kGraded.at(centroid(p)) * (1 + 1e-12));
    for (std::size_t k = 0; k < 3; ++k) {
      const Point a = p[(k + 1) % 3] - p[k];
      const Point b = p[(k + 2) % 3] - p[k];
      EXPECT_GT(std::atan2(cross(a, b), dot(a, b)), 20 * std::acos(-1.0) / 180);
    }
  }
}

TEST(UnstructuredMesh, is_fine_at_refined_points_and_coarse_elsewhere) {
  const TriangleMesh mesh = unstructured_mesh(kBox, kGraded);
  const MeshSize fine{0.04, {}, 0.3};
  double far = 0;
  for (const auto& t : mesh.triangles) far = std::max(far, longest_side(corners(mesh, t)));
  EXPECT_GT(far, 0.3);
  EXPECT_NE(std::find(mesh.nodes.begin(), mesh.nodes.end(), Point{1, 1.3}), mesh.nodes.end());
  EXPECT_LT(3 * mesh.triangles.size(), unstructured_mesh(kBox, fine).triangles.size());
}

// r cos(π/2) is 6e-17 r. Triangles between such a point and the line beside it have no area that coordinates resolve.
TEST(UnstructuredMesh, refined_points_beside_lines_corners_and_one_another_refine_and_get_no_node_of_their_own) {
  for (const double angle : {0.0, 0.4, 1.1})
    for (const double off : {0.0, 6e-17, -6e-17, 1e-14, 1e-10, 1e-8, 1e-6, 1e-4, 1e-3}) {
      const auto placed = [&](Point p) {
        return Point{5 + std::cos(angle) * p.x - std::sin(angle) * p.y,
                     3 + std::sin(angle) * p.x + std::cos(angle) * p.y};
      };
      std::vector<Segment> sides;
      Box box;
      for (const Segment& s : rectangle_sides({0, 0}, {4, 4})) {
        sides.push_back({placed(s.start), placed(s.end)});
        box.add(sides.back().start);
      }
      const MeshSize size(1,
                          {{placed({off, 1}), 0.07},
                           {placed({off, off}), 0.07},
                           {placed({4 - off, 4}), 0.07},
                           {placed({2, 2}), 0.07},
                           {placed({2 + off, 2}), 0.07}},
                          0.3);
      const TriangleMesh mesh = unstructured_mesh(box, size, sides);
      EXPECT_LT(mesh.triangles.size(), 20000U) << angle << ", " << off;
      for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
          EXPECT_GT(distance(mesh.nodes[static_cast<std::size_t>(t[k])],
                             mesh.nodes[static_cast<std::size_t>(t[(k + 1) % 3])]),
                    0.1 * 0.07)
              << angle << ", " << off;
      EXPECT_GT(mesh.triangles.size(), 500U) << angle << ", " << off;
    }
}

TEST(UnstructuredMesh, is_cut_like_a_regular_one) {
  const BodyCut bodies = cut_bodies(
      drawing_of(rectangle_sides(kBox.low, kBox.high) + std::vector<Segment>{{{1, 2}, {1, 1.3}}, {{2, 0}, {2.5, 2}}}));
  const Manifold manifold = cut_cover(bodies.graph, unstructured_mesh(kBox, kGraded));
  expect_sound(manifold);
  EXPECT_NEAR(area_within_loops(manifold), 8, 1e-12);
  EXPECT_GT(manifold.elements.size(), 200U);
}

TEST(UnstructuredMesh, along_the_lines_of_a_drawing_no_triangle_is_cut) {
  const BodyCut bodies = cut_bodies(drawing_of(rectangle_sides(kBox.low, kBox.high) +
                                               std::vector<Segment>{{{0.3, 1.7}, {3.1, 0.4}}, {{1, 0}, {2.7, 2}}}));
  std::vector<Segment> along;
  for (const BodyPiece& piece : bodies.graph.pieces)
    along.push_back({bodies.graph.nodes[static_cast<std::size_t>(piece.from)],
                     bodies.graph.nodes[static_cast<std::size_t>(piece.to)]});
  const Manifold manifold = cut_cover(bodies.graph, unstructured_mesh(kBox, {0.3, {}, 0.3}, along));
  expect_sound(manifold);
  for (const ManifoldElement& element : manifold.elements) {
    const std::array<Point, 3> t = manifold.triangle(element);
    EXPECT_NEAR(area(manifold, element), area(t), 1e-13);
  }
}

TEST(UnstructuredMesh, is_the_same_every_time) {
  const TriangleMesh first = unstructured_mesh(kBox, kGraded);
  const TriangleMesh second = unstructured_mesh(kBox, kGraded);
  EXPECT_EQ(first.nodes, second.nodes);
  EXPECT_EQ(first.triangles, second.triangles);
}

// Sides of 1e-16 at a point of coordinates about 1 coincide: refinement would not end.
TEST(UnstructuredMesh, sides_that_coordinates_do_not_resolve_are_refused) {
  const BodyGraph graph = cut_bodies(drawing_of(rectangle_sides({0, 0}, {10, 10}), 0)).graph;
  MeshPlan plan;
  plan.kind = MeshKind::unstructured;
  plan.side = 5;
  plan.refined = {{{5, 5}, 1e-6}};
  EXPECT_FALSE(fitted_mesh(plan, graph).mesh.triangles.empty());
  for (const double side : {1e-16, 5e-324}) {
    plan.refined[0].side = side;
    EXPECT_THROW(fitted_mesh(plan, graph), std::invalid_argument) << side;
  }
}

}  // namespace keyblock::unstructured_mesh_test
