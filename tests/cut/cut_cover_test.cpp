// Effect of joints on a mesh: they cut triangles into elements and stars into covers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/covers/cut_cover.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "cut/bodies/cut_blocks.hpp"
#include "cut/mesh/background_mesh.hpp"
#include "tests/cut/drawings.hpp"
#include "tests/cut/manifolds.hpp"

namespace keyblock::cut_cover_test {
namespace {

/// Six triangles about node 0 in the origin, nodes 1 to 6 on the circle of radius 2 from the x direction on.
TriangleMesh hexagon() {
  TriangleMesh mesh;
  mesh.nodes.push_back({0, 0});
  for (int k = 0; k < 6; ++k) {
    const double angle = k * std::acos(-1.0) / 3;
    mesh.nodes.push_back({2 * std::cos(angle), 2 * std::sin(angle)});
    mesh.triangles.push_back({0, k + 1, (k + 1) % 6 + 1});
  }
  return mesh;
}

/// A square of side 2 about the origin with further lines, cut by the hexagon.
Manifold cut_square(const std::vector<Segment>& lines) {
  const Manifold manifold =
      cut_cover(cut_bodies(drawing_of(rectangle_sides({-1, -1}, {1, 1}) + lines)).graph, hexagon());
  expect_sound(manifold);
  return manifold;
}

int covers_at(const Manifold& manifold, int node) {
  return static_cast<int>(std::count_if(manifold.covers.begin(), manifold.covers.end(),
                                        [&](const PhysicalCover& cover) { return cover.node == node; }));
}

Manifold cut_by_regular(const Drawing& drawing, const RegularMesh& mesh, const Box& box) {
  return cut_cover(cut_bodies(drawing).graph, regular_triangles(box, mesh));
}

}  // namespace

TEST(CutCover, a_whole_body_has_one_cover_a_node) {
  const Manifold whole = cut_square({});
  EXPECT_EQ(whole.elements.size(), 6U);
  EXPECT_EQ(whole.covers.size(), 7U);
  EXPECT_EQ(whole.boundary_loops.size(), 1U);
  EXPECT_NEAR(areas_of_bodies(whole)[0], 4, 1e-14);
}

// y = 0.2 from side to side passes through all triangles but the lower three.
TEST(CutCover, a_joint_through_the_body_doubles_the_covers_of_every_star_it_parts) {
  const Manifold cut = cut_square({{{-1.1, 0.2}, {1.1, 0.2}}});
  EXPECT_EQ(cut.body_materials.size(), 2U);
  EXPECT_EQ(cut.elements.size(), 9U);
  EXPECT_EQ(covers_at(cut, 0), 2);
  EXPECT_EQ(cut.boundary_loops.size(), 2U);
  EXPECT_NEAR(areas_of_bodies(cut)[0] + areas_of_bodies(cut)[1], 4, 1e-14);
}

// From the right side, beyond the side 0-2 of the mesh (x = 0.1155 at y = 0.2), ending in the next triangle: the first
// triangle is parted, the star of the origin is not.
TEST(CutCover, a_crack_that_ends_inside_a_star_leaves_it_whole) {
  const Manifold cut = cut_square({{{1, 0.2}, {0, 0.2}}});
  EXPECT_EQ(cut.body_materials.size(), 1U);
  EXPECT_EQ(cut.elements.size(), 7U);
  EXPECT_EQ(covers_at(cut, 0), 1);
  EXPECT_EQ(covers_at(cut, 1), 2) << "its star is one side of the crack and the other, with no way around";
  EXPECT_EQ(covers_at(cut, 2), 1);
  EXPECT_EQ(cut.boundary_loops.size(), 1U);
  EXPECT_NEAR(area_within_loops(cut), 4, 1e-14);
}

TEST(CutCover, a_crack_within_one_triangle_parts_nothing) {
  const Manifold cut = cut_square({{{1, 0.2}, {0.5, 0.2}}, {{0.3, -0.4}, {0.4, -0.3}}});
  EXPECT_EQ(cut.elements.size(), 6U);
  EXPECT_EQ(cut.covers.size(), 7U);
}

TEST(CutCover, a_crack_along_a_side_of_the_mesh_parts_no_triangle_but_the_covers_of_its_node) {
  const Manifold cut = cut_square({{{-1, 0}, {0, 0}}});
  EXPECT_EQ(cut.elements.size(), 6U);
  EXPECT_EQ(covers_at(cut, 0), 1) << "the crack ends in the node";
  EXPECT_EQ(covers_at(cut, 4), 2);
  EXPECT_EQ(cut.covers.size(), 8U);
}

TEST(CutCover, a_joint_along_sides_of_the_mesh_parts_bodies_without_a_new_element) {
  const Manifold cut = cut_square({{{-1.1, 0}, {1.1, 0}}});
  EXPECT_EQ(cut.elements.size(), 6U);
  EXPECT_EQ(covers_at(cut, 0), 2);
  EXPECT_EQ(cut.covers.size(), 10U);
  EXPECT_EQ(cut.boundary_loops.size(), 2U);
}

// The hole lies inside triangle 0 (corners (0,0), (2,0), (1,1.73)): an element with a hole.
TEST(CutCover, a_hole_inside_a_triangle_is_a_hole_of_its_element) {
  Drawing drawing = drawing_of(rectangle_sides({-1, -1}, {1, 1}) + rectangle_sides({0.5, 0.2}, {0.7, 0.4}));
  drawing.hole_points.push_back({{0.6, 0.3}, {}});
  const Manifold cut = cut_cover(cut_bodies(drawing).graph, hexagon());
  expect_sound(cut);
  EXPECT_EQ(cut.elements.size(), 6U);
  ASSERT_EQ(cut.holes.size(), 1U);
  EXPECT_EQ(cut.boundary_loops.size(), 2U);
  EXPECT_NEAR(areas_of_bodies(cut)[0], 3.96, 1e-14);
}

TEST(CutCover, a_body_inside_a_triangle_is_one_element) {
  const Manifold cut = cut_cover(cut_bodies(drawing_of(rectangle_sides({0.5, 0.2}, {0.7, 0.4}))).graph, hexagon());
  expect_sound(cut);
  EXPECT_EQ(cut.elements.size(), 1U);
  EXPECT_EQ(cut.elements[0].triangle, 0);
  EXPECT_EQ(cut.covers.size(), 3U);
}

TEST(CutCover, a_block_of_a_block_file_is_cut_as_its_drawing_is) {
  Drawing drawing = drawing_of(rectangle_sides({-1, -1}, {1, 1}) + rectangle_sides({-0.3, -0.2}, {0.7, 0.4}));
  drawing.hole_points.push_back({{0.1, 0.1}, {}});
  const BodyCut cut = cut_bodies(drawing);
  const Manifold from_drawing = cut_cover(cut.graph, hexagon());
  const Manifold from_block = cut_cover(graph_of(cut.blocks.blocks.blocks[0]), hexagon());
  expect_sound(from_block);
  EXPECT_EQ(from_block.elements.size(), from_drawing.elements.size());
  EXPECT_EQ(from_block.covers.size(), from_drawing.covers.size());
  EXPECT_NEAR(areas_of_bodies(from_block)[0], 4 - 0.6, 1e-14);
  const auto materials = [](const Manifold& manifold) {
    std::vector<double> lengths(8, 0);
    for (const ElementEdge& edge : edges_of(manifold)) {
      const ElementCorner& from = manifold.corners[static_cast<std::size_t>(edge.from)];
      if (from.neighbour >= 0) continue;
      lengths[static_cast<std::size_t>(from.joint_material)] +=
          distance(from.position, manifold.corners[static_cast<std::size_t>(edge.to)].position);
    }
    return lengths;
  };
  for (std::size_t line = 0; line < 8; ++line)
    EXPECT_NEAR(materials(from_block)[line], materials(from_drawing)[line], 1e-14) << "line " << line;
}

TEST(CutCover, joint_materials_stand_at_the_edges_of_both_sides) {
  const Manifold cut = cut_square({{{-1.1, 0.2}, {1.1, 0.2}}});
  int count = 0;
  for (const ElementEdge& edge : edges_of(cut)) {
    const ElementCorner& from = cut.corners[static_cast<std::size_t>(edge.from)];
    const ElementCorner& to = cut.corners[static_cast<std::size_t>(edge.to)];
    if (from.position.y != 0.2 || to.position.y != 0.2) continue;
    EXPECT_EQ(from.joint_material, 4);
    ++count;
  }
  EXPECT_EQ(count, 6) << "three triangles, two sides";
}

// The upper edge lies 1e-8 of a row above a row of the mesh: as many elements as with 0.3 of a row.
TEST(CutCover, slivers_of_1e_8_survive) {
  const Box box{{0, 0}, {2, 2}};
  const RegularMesh mesh{2 / std::sqrt(3.0), 1, {0.05, 0.1}, 0};
  const auto cut = [&](double above) {
    const Manifold manifold = cut_by_regular(drawing_of(rectangle_sides({0, 0}, {2, 1.1 + above})), mesh, box);
    expect_sound(manifold);
    return manifold;
  };
  const Manifold thin = cut(1e-8);
  EXPECT_EQ(thin.elements.size(), cut(0.3).elements.size());
  double above = 0;
  for (const ManifoldElement& element : thin.elements) {
    const double own = area(thin, element);
    EXPECT_GT(own, 0);
    if (own < 1e-6) above += own;
  }
  EXPECT_NEAR(above, 2e-8, 1e-14);
}

// 0.1 + 0.2 is one unit in the last place above 0.3, where a row stands: no layer of elements without thickness, on
// either side of the row.
TEST(CutCover, an_edge_on_a_row_up_to_round_off_makes_no_slivers) {
  const Box box{{0, 0}, {1, 0.5}};
  const auto elements = [&](double top, double row) {
    const Manifold manifold =
        cut_by_regular(drawing_of(rectangle_sides({0, 0}, {1, top})), {0.2, 0.1, {0.013, row}, 0}, box);
    expect_sound(manifold);
    EXPECT_NEAR(areas_of_bodies(manifold)[0], top, 1e-15);
    return manifold.elements.size();
  };
  ASSERT_NE(0.1 + 0.2, 0.3);
  EXPECT_EQ(elements(0.1 + 0.2, 0.3), elements(0.3, 0.3));
  EXPECT_EQ(elements(0.3, 0.1 + 0.2), elements(0.3, 0.3));
}

TEST(CutCover, a_mesh_that_leaves_part_of_a_body_bare_is_refused) {
  EXPECT_THROW(cut_cover(cut_bodies(drawing_of(rectangle_sides({-3, -1}, {1, 1}))).graph, hexagon()),
               std::invalid_argument);
}

}  // namespace keyblock::cut_cover_test
