// Cracks in a graph of bodies: their ends, the surroundings of their tips, refusals, and cutting along them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/cracks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "cut/covers/cut_cover.hpp"
#include "cut/mesh/fit_mesh.hpp"
#include "geometry/polygon.hpp"

namespace keyblock::cracks_test {
namespace {

BodyGraph square(double side = 1) {
  BlockPolygon block;
  for (const Point p : {Point{0, 0}, Point{side, 0}, Point{side, side}, Point{0, side}}) block.outer.push_back({p, 0});
  return graph_of(block);
}

std::vector<CrackTip> tips_with(BodyGraph graph, const std::vector<CrackPlan>& cracks) {
  add_cracks({&graph, 1}, cracks, CracksOutside::are_refused);
  return tips_of(graph);
}

std::string fault_of(const std::vector<CrackPlan>& cracks) {
  try {
    tips_with(square(), cracks);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

CrackPlan crack(std::vector<Point> along) {
  return {std::move(along), {}, 0};
}

double area_of(const Manifold& manifold) {
  double sum = 0;
  for (const ManifoldElement& element : manifold.elements)
    for (const std::vector<Point>& loop : manifold.polygon(element)) sum += area(loop);
  return sum;
}

TEST(Cracks, an_end_inside_is_a_tip_and_knows_what_is_near) {
  const auto tips = tips_with(square(), {crack({{0, 0.5}, {0.3, 0.5}})});
  ASSERT_EQ(tips.size(), 1U);
  EXPECT_EQ(tips[0].at, (Point{0.3, 0.5}));
  EXPECT_NEAR(distance(tips[0].ahead, {1, 0}), 0, 1e-15);
  EXPECT_NEAR(tips[0].room, 0.3, 1e-15);  // the mouth on the boundary
  EXPECT_STREQ(tips[0].nearest, "the outline of a body");
}

TEST(Cracks, kinks_other_tips_and_other_cracks_are_named) {
  const auto kinked = tips_with(square(), {crack({{0.2, 0.3}, {0.5, 0.5}, {0.6, 0.5}})});
  ASSERT_EQ(kinked.size(), 2U);
  EXPECT_STREQ(kinked[1].nearest, "a kink of the crack itself");
  EXPECT_NEAR(kinked[1].room, 0.1, 1e-15);
  const auto apart = tips_with(square(), {crack({{0.2, 0.5}, {0.45, 0.5}}), crack({{0.5, 0.5}, {0.8, 0.5}})});
  ASSERT_EQ(apart.size(), 4U);
  EXPECT_NEAR(apart[1].room, 0.05, 1e-15);
  const auto beside = tips_with(square(), {crack({{0.3, 0.5}, {0.7, 0.5}}), crack({{0.5, 0.52}, {0.5, 0.9}})});
  EXPECT_STREQ(beside[2].nearest, "a joint or another crack");
}

TEST(Cracks, an_end_on_a_line_is_no_tip) {
  EXPECT_EQ(tips_with(square(), {crack({{0, 0.3}, {1, 0.7}})}).size(), 0U);
  EXPECT_EQ(tips_with(square(), {crack({{-0.5, 0.5}, {1.5, 0.5}})}).size(), 0U);
  EXPECT_EQ(tips_with(square(), {crack({{0, 0.5}, {0.5, 0.5}}), crack({{0.25, 0.5}, {0.25, 0.8}})}).size(), 2U);
  // 1e-9 before the boundary it stays as it is drawn.
  EXPECT_EQ(tips_with(square(), {crack({{0, 0.3}, {1 - 1e-9, 0.7}})}).size(), 1U);
}

TEST(Cracks, ends_that_meet_are_no_tips) {
  // Two that share an end, at a corner and straight on; three tips of a T.
  EXPECT_EQ(tips_with(square(), {crack({{0.2, 0.3}, {0.5, 0.5}}), crack({{0.5, 0.5}, {0.8, 0.4}})}).size(), 2U);
  EXPECT_EQ(tips_with(square(), {crack({{0.2, 0.5}, {0.5, 0.5}}), crack({{0.5, 0.5}, {0.8, 0.5}})}).size(), 2U);
  EXPECT_EQ(tips_with(square(), {crack({{0.2, 0.5}, {0.8, 0.5}}), crack({{0.4, 0.5}, {0.4, 0.8}})}).size(), 3U);
}

TEST(Cracks, what_no_body_can_have_is_refused) {
  EXPECT_NE(fault_of({crack({{2, 2}, {3, 3}})}).find("expected a crack in a body, found none of it there: (2, 2)"),
            std::string::npos);
  EXPECT_NE(fault_of({crack({{0.5, 0.5}, {0.5, 0.5}})}).find("found (0.5, 0.5) twice in a row"), std::string::npos);
  EXPECT_NE(fault_of({crack({{0.5, 0}, {1, 0}, {1, 0.5}})}).find("along the outline of a body"), std::string::npos);
  EXPECT_NE(fault_of({crack({{0.2, 0.5}, {0.7, 0.5}, {0.4, 0.5}})}).find("along itself"), std::string::npos);
  EXPECT_NE(fault_of({crack({{0.2, 0.5}, {0.6, 0.5}}), crack({{0.4, 0.5}, {0.8, 0.5}})})
                .find("along a joint or another crack"),
            std::string::npos);
}

// An end on a boundary is moved a little beyond it; messages give its place in the file.
TEST(Cracks, one_that_is_drawn_twice_is_told_of_as_it_is_drawn) {
  const CrackPlan from_edge = crack({{0, 0.5}, {0.5, 0.5}});
  EXPECT_EQ(fault_of({from_edge, from_edge}),
            ": error: expected a crack apart from other lines, found it along a joint or another crack from (0, 0.5) "
            "to (0.5, "
            "0.5)");
}

TEST(Cracks, a_crack_from_side_to_side_parts_all_covers) {
  BodyGraph graph = square();
  const std::vector<CrackPlan> cracks{crack({{0, 0.31}, {1, 0.67}})};
  add_cracks({&graph, 1}, cracks, CracksOutside::are_refused);
  MeshPlan plan;
  plan.side = 0.2;
  plan.angle_deg = 10;
  const Manifold manifold = cut_cover(graph, fitted_mesh(plan, graph).mesh);
  const auto is_above = [](Point p) { return p.y > 0.31 + 0.36 * p.x; };
  for (const PhysicalCover& cover : manifold.covers) {
    const auto elements = manifold.elements_of(cover);
    const auto above = std::ranges::count_if(elements, [&](int e) {
      return is_above(centroid(manifold.polygon(manifold.elements[static_cast<std::size_t>(e)]).front()));
    });
    EXPECT_TRUE(above == 0 || above == static_cast<std::ptrdiff_t>(elements.size()));
  }
}

// Random cracks: through nodes, along sides of the mesh, nearly closed, ending 1e-9 from a boundary, meeting, cutting
// in two. Their area is that of the body.
TEST(Cracks, a_thousand_random_ones_are_cut_without_loss) {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> in(0.02, 0.98);
  MeshPlan plan;
  plan.side = 0.17;
  for (int i = 0; i < 1000; ++i) {
    plan.angle_deg = i % 3 == 0 ? 0 : 60 * in(random);
    plan.tip_side = i % 2 == 0 ? 0.02 : 0;
    BodyGraph graph = square();
    const TriangleMesh mesh = fitted_mesh(plan, graph).mesh;
    const auto node = [&] {
      for (;;) {
        const Point p = mesh.nodes[random() % mesh.nodes.size()];
        if (p.x > 0.05 && p.x < 0.95 && p.y > 0.05 && p.y < 0.95) return p;
      }
    };
    const Point a{in(random), in(random)}, b{in(random), in(random)};
    CrackPlan one;
    switch (i % 8) {
      case 0:
        one = crack({a, b});
        break;
      case 1:
        one = crack({a, node()});
        break;
      case 2:
        one = crack({node(), node(), b});
        break;
      case 3:
        one = crack({a, {1 - 1e-9, b.y}});
        break;
      case 4:
        one = crack({{0, a.y}, {1, b.y}});
        break;
      case 5:
        one = crack({a, b, {a.x + 1e-6, a.y + 1e-6}});
        break;
      case 6:
        one = crack({node(), b, {0, 0.5}});
        break;
      default:
        one = crack({{0, a.y}, a, {b.x, 1}});
    }
    std::vector<CrackPlan> cracks{one};
    if (i % 5 == 0) cracks.push_back(crack({0.5 * (one.along[0] + one.along[1]), {in(random), in(random)}}));
    try {
      add_cracks({&graph, 1}, cracks, CracksOutside::are_refused);
    } catch (const InputError&) {
      continue;  // two points in one place
    }
    std::vector<Point> tips;
    for (const CrackTip& tip : tips_of(graph)) tips.push_back(tip.at);
    const Manifold manifold = cut_cover(graph, fitted_mesh(plan, graph, tips).mesh);
    ASSERT_NEAR(area_of(manifold), 1, 1e-12) << i;
    ASSERT_FALSE(manifold.covers.empty());
  }
}

}  // namespace
}  // namespace keyblock::cracks_test
