// Meshes of plans: the messages of `tip_side` about the triangles at tips.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/mesh/fit_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "cut/bodies/cracks.hpp"
#include "geometry/polygon.hpp"

namespace keyblock::fit_mesh_test {
namespace {

BodyGraph cracked_plate(Point tip) {
  BlockPolygon block;
  for (const Point p : {Point{0, -1}, Point{1, -1}, Point{1, 1}, Point{0, 1}}) block.outer.push_back({p, 0});
  std::vector<BodyGraph> graphs{graph_of(block)};
  const std::vector<CrackPlan> cracks{{{{0, 0.03}, tip}, {}}};
  add_cracks(graphs, cracks, CracksOutside::are_refused);
  return graphs.front();
}

double longest_side_at(const TriangleMesh& mesh, Point tip) {
  double longest = 0;
  for (const auto& t : mesh.triangles) {
    std::array<Point, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.nodes[static_cast<std::size_t>(t[k])];
    if (side(p, tip) == Side::outside) continue;
    for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, distance(p[k], p[(k + 1) % 3]));
  }
  return longest;
}

}  // namespace

TEST(FitMesh, tip_side_is_the_longest_side_at_the_tips) {
  for (const MeshKind kind : {MeshKind::regular, MeshKind::unstructured})
    for (const MeshPlacement placement : {MeshPlacement::free, MeshPlacement::aligned})
      for (const double tip_side : {0.1, 0.0625, 0.04, 0.02, 0.0123, 0.005, 0.0016}) {
        MeshPlan plan;
        plan.kind = kind;
        plan.placement = placement;
        plan.side = 0.17;
        plan.angle_deg = kind == MeshKind::regular && placement == MeshPlacement::free ? 10 : 0;
        plan.tip_side = tip_side;
        const Point tip{0.47, 0.1};
        const double longest = longest_side_at(fitted_mesh(plan, cracked_plate(tip), {&tip, 1}).mesh, tip);
        EXPECT_LE(longest, tip_side * (1 + 1e-9)) << static_cast<int>(kind) << static_cast<int>(placement);
        EXPECT_GT(longest, tip_side / 3) << static_cast<int>(kind) << static_cast<int>(placement);
      }
}

}  // namespace keyblock::fit_mesh_test
