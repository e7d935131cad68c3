// Excavation: the rest has the area of the difference, and each body its material.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/excavate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "cut/covers/cut_cover.hpp"
#include "cut/covers/join_manifolds.hpp"
#include "cut/mesh/fit_mesh.hpp"
#include "geometry/polygon.hpp"

namespace keyblock::excavate_test {
namespace {

BlockPolygon rectangle(Point low, Point high, int material) {
  return {material, {{low, 0}, {{high.x, low.y}, 0}, {high, 0}, {{low.x, high.y}, 0}}, {}};
}

MeshPlan plan_of(double side) {
  MeshPlan plan;
  plan.side = side;
  plan.angle_deg = 10;
  return plan;
}

double area_of(const Manifold& manifold, int material) {
  double sum = 0;
  for (const ManifoldElement& element : manifold.elements) {
    if (manifold.body_materials[static_cast<std::size_t>(element.body)] != material) continue;
    for (const auto& loop : manifold.polygon(element)) sum += area(loop);
  }
  return sum;
}

}  // namespace

TEST(Excavate, what_is_left_has_the_area_of_the_difference_and_its_material) {
  Blocks blocks;
  blocks.blocks = {rectangle({0, 0}, {4, 2}, 3), rectangle({4, 0}, {6, 2}, 5)};
  // Reaches over the joint of the two, down to their lower edge.
  const std::vector<Point> outline{{3, 0}, {5, 0}, {5, 1}, {3, 1}};
  const BodyGraph rest = excavated(lines_of(blocks), {{outline, 0}}, NodeMerging::nearest_first, &blocks);
  EXPECT_EQ(std::set<int>(rest.materials.begin(), rest.materials.end()), (std::set<int>{3, 5}));
  const Manifold manifold = cut_cover(rest, fitted_mesh(plan_of(0.3), rest).mesh);
  EXPECT_NEAR(area_of(manifold, 3), 7, 1e-12);
  EXPECT_NEAR(area_of(manifold, 5), 3, 1e-12);
}

TEST(Excavate, a_body_that_an_outline_parts_becomes_two) {
  Blocks blocks;
  blocks.blocks = {rectangle({0, 0}, {4, 2}, 1)};
  const std::vector<Point> trench{{1, -1}, {2, -1}, {2, 3}, {1, 3}};
  const BodyGraph rest = excavated(lines_of(blocks), {{trench, 0}}, NodeMerging::nearest_first, &blocks);
  EXPECT_EQ(rest.materials, (std::vector<int>{1, 1}));
  const std::vector<Point> all{{-1, -1}, {9, -1}, {9, 9}, {-1, 9}};
  EXPECT_THROW(excavated(lines_of(blocks), {{all, 0}}, NodeMerging::nearest_first, &blocks), InputError);
}

TEST(JoinManifolds, bodies_cut_one_by_one_stand_side_by_side) {
  const MeshPlan plan = plan_of(0.4);
  const BodyGraph left = graph_of(rectangle({0, 0}, {2, 1}, 0));
  const BodyGraph right = graph_of(rectangle({2, 0}, {3, 1}, 1));
  BodyGraph both = left;
  both.nodes.insert(both.nodes.end(), right.nodes.begin(), right.nodes.end());
  for (BodyPiece piece : right.pieces) {
    piece.from += static_cast<int>(left.nodes.size());
    piece.to += static_cast<int>(left.nodes.size());
    both.pieces.push_back(piece);
  }
  const TriangleMesh mesh = fitted_mesh(plan, both).mesh;
  Manifold joined = cut_cover(left, mesh);
  const Manifold first = joined;
  const Manifold second = cut_cover(right, mesh);
  join(joined, second);
  EXPECT_EQ(joined.elements.size(), first.elements.size() + second.elements.size());
  EXPECT_EQ(joined.covers.size(), first.covers.size() + second.covers.size());
  EXPECT_NEAR(area_of(joined, 0), 2, 1e-13);
  EXPECT_NEAR(area_of(joined, 1), 1, 1e-13);
  for (std::size_t e = first.elements.size(); e < joined.elements.size(); ++e) {
    EXPECT_EQ(joined.elements[e].body, 1);
    for (const int cover : joined.elements[e].covers) {
      const auto elements = joined.elements_of(joined.covers[static_cast<std::size_t>(cover)]);
      EXPECT_NE(std::find(elements.begin(), elements.end(), static_cast<int>(e)), elements.end());
    }
  }
  for (const BoundaryEdge& edge : joined.boundary_edges) {
    const SlotRange& outer = joined.elements[static_cast<std::size_t>(edge.element)].outer;
    EXPECT_TRUE(edge.corner >= outer.first && edge.corner < outer.first + outer.size);
  }
}

}  // namespace keyblock::excavate_test
