// A model of elements on covers has the corners, covers and materials of the cut mesh, and knows which edges lie
// inside.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setup/from_manifold.hpp"

#include <gtest/gtest.h>

#include "cut/bodies/cut_blocks.hpp"
#include "cut/covers/cut_cover.hpp"
#include "cut/mesh/background_mesh.hpp"
#include "tests/cut/drawings.hpp"

namespace keyblock::from_manifold_test {
namespace {

// A square of 1 parted at x = 0.4 by a joint of material 2, on triangles.
Manifold parted_square() {
  Drawing drawing = drawing_of(rectangle_sides({0, 0}, {1, 1}) + std::vector<Segment>{{{0.4, -0.1}, {0.4, 1.1}}}, 1e-4);
  for (JointLine& line : drawing.joints) line.joint_material = &line == &drawing.joints.back() ? 1 : 0;
  const Box box{{0, 0}, {1, 1}};
  return cut_cover(cut_bodies(drawing).graph, regular_triangles(box, centred_mesh(box, 2, MeshShape::equilateral)));
}

Analysis two_materials() {
  Analysis analysis;
  analysis.block_materials.resize(1);
  analysis.joint_materials.resize(2);
  analysis.point_loads = {TimeCurve{{0}, {{3, 4}}, {}}};
  return analysis;
}

}  // namespace

TEST(ModelFromManifold, boundary_edges_are_those_of_the_bodies_and_carry_their_joint_materials) {
  const Manifold manifold = parted_square();
  const Model model = model_from_manifold(manifold, {}, two_materials());
  double outer = 0;
  double joint = 0;
  double inner = 0;
  for (VertexIndex v : indices(model.vertices)) {
    const Vertex& vertex = model.vertices[v];
    const double edge = distance(model.start_vertices[static_cast<std::size_t>(vertex.previous.value)],
                                 model.start_vertices[static_cast<std::size_t>(v.value)]);
    (vertex.is_inner ? inner : vertex.joint_material == 1 ? joint : outer) += edge;
  }
  EXPECT_NEAR(outer, 4, 1e-12) << "around both bodies, without the joint";
  EXPECT_NEAR(joint, 2, 1e-12) << "the joint from both sides";
  EXPECT_GT(inner, 0);
}

TEST(ModelFromManifold, elements_across_a_joint_share_no_cover_and_neighbours_do) {
  const Manifold manifold = parted_square();
  const Model model = model_from_manifold(manifold, {}, two_materials());
  ASSERT_EQ(model.elements.size(), manifold.elements.size());
  for (ElementIndex a : indices(model.elements)) {
    EXPECT_TRUE(share_a_cover(model.elements[a], model.elements[a]));
    for (ElementIndex b : indices(model.elements)) {
      const auto& first = manifold.elements[static_cast<std::size_t>(a.value)];
      const auto& second = manifold.elements[static_cast<std::size_t>(b.value)];
      if (first.body == second.body) continue;
      EXPECT_FALSE(share_a_cover(model.elements[a], model.elements[b]));
    }
  }
  for (std::size_t e = 0; e < manifold.elements.size(); ++e) {
    for (const ElementCorner& corner : manifold.loop(manifold.elements[e].outer)) {
      if (corner.neighbour < 0) continue;
      EXPECT_TRUE(share_a_cover(model.elements[{static_cast<int>(e)}], model.elements[{corner.neighbour}]));
    }
  }
}

TEST(ModelFromManifold, the_boundary_is_walked_from_element_to_element) {
  const Model model = model_from_manifold(parted_square(), {}, two_materials());
  const auto at = [&](VertexIndex v) { return model.start_vertices[static_cast<std::size_t>(v.value)]; };
  double walked = 0;
  for (VertexIndex v : indices(model.vertices)) {
    const Vertex& vertex = model.vertices[v];
    const bool leaves_inward = model.vertices[vertex.next].is_inner;
    EXPECT_EQ(static_cast<bool>(vertex.boundary_next), !leaves_inward);
    if (leaves_inward) continue;
    EXPECT_EQ(model.vertices[vertex.boundary_next].boundary_previous, v);
    EXPECT_EQ(at(vertex.boundary_next), at(vertex.next));
    walked += distance(at(v), at(vertex.boundary_next));
  }
  EXPECT_NEAR(walked, 6, 1e-12);
}

TEST(ModelFromManifold, points_carry_their_loads_and_the_scale_is_half_the_extent) {
  const Manifold manifold = parted_square();
  const ElementPoints points{{{{0, 0}, 0, {}}}, {{{1, 1}, 1, {}}, {{0, 1}, 2, {}}}, {}};
  const Model model = model_from_manifold(manifold, points, two_materials());
  ASSERT_EQ(model.loading_points.size(), 2U);
  EXPECT_EQ(model.loading_points[0].element, (ElementIndex{1}));
  EXPECT_EQ(model.loading_points[0].curve.at(7), (Point{3, 4}));
  EXPECT_TRUE(model.loading_points[1].curve.times.empty());
  EXPECT_EQ(model.fixed_points[0].start, (Point{0, 0}));
  EXPECT_DOUBLE_EQ(model.scale, 0.5);
  EXPECT_NEAR(model.mean_area * static_cast<double>(model.elements.size()), 1, 1e-12);
}

}  // namespace keyblock::from_manifold_test
