// Functions about crack tips: their gradients, their span, and the continuity of θ in connected rock.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tips/tip_enrichment.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

#include "cut/bodies/cracks.hpp"
#include "cut/covers/cut_cover.hpp"
#include "cut/mesh/fit_mesh.hpp"
#include "fracture/near_tip_field.hpp"
#include "model/cover_basis.hpp"
#include "tests/support/near_tip_displacement.hpp"

namespace keyblock::tip_enrichment_test {
namespace {

/// A unit square about the origin on a mesh of sides `side`, with these cracks.
Manifold cracked_square(const std::vector<std::vector<Point>>& cracks, double side) {
  BodyGraph graph;
  graph.materials = {0};
  graph.nodes = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  for (int i = 0; i < 4; ++i) graph.pieces.push_back({i, (i + 1) % 4, false, 0, -1, 0});
  std::vector<CrackPlan> plans;
  for (const std::vector<Point>& along : cracks) plans.emplace_back().along = along;
  add_cracks({&graph, 1}, plans, CracksOutside::are_refused);
  std::vector<Point> tips;
  for (const CrackTip& tip : tips_of(graph)) tips.push_back(tip.at);
  MeshPlan mesh;
  mesh.side = side;
  mesh.angle_deg = 10;
  mesh.through_x = 0.0137;
  mesh.through_y = 0.0071;
  mesh.tip_functions.kind = TipFunctions::williams;
  return cut_cover(graph, fitted_mesh(mesh, graph, tips).mesh);
}

/// Field of one component: unknown 1 for function `f` alone.
double value(const CoverBasis& basis, int element, int f, Point x) {
  const ElementShape shape = basis.shape(element);
  const Eigen::RowVectorXd n = shape.values(x);
  for (std::size_t a = 0; a < shape.functions.size(); ++a)
    if (shape.functions[a] == f) return n(static_cast<Eigen::Index>(a));
  return 0;
}

/// The largest jump of any function across the sides that elements share, and the number of sides.
std::pair<double, int> greatest_jump(const Manifold& manifold, const CoverBasis& basis) {
  double jump = 0;
  int sides = 0;
  for (int e = 0; e < basis.element_count(); ++e) {
    const auto loop = manifold.loop(manifold.elements[static_cast<std::size_t>(e)].outer);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (loop[i].neighbour < 0) continue;
      const Point next = loop[(i + 1) % loop.size()].position;
      const Point x = 0.7 * loop[i].position + 0.3 * next;
      ++sides;
      for (const int which : {e, loop[i].neighbour})
        for (const int f : basis.shape(which).functions)
          jump = std::max(jump, std::abs(value(basis, e, f, x) - value(basis, loop[i].neighbour, f, x)));
    }
  }
  return {jump, sides};
}

int tip_function_count(const CoverBasis& basis) {
  int count = 0;
  for (int e = 0; e < basis.element_count(); ++e)
    if (const ElementShape shape = basis.shape(e); shape.tip != nullptr)
      count += static_cast<int>(shape.tip->functions.size());
  return count;
}

constexpr TipFunctionPlan kWilliams{TipFunctions::williams, 0};

}  // namespace

TEST(NearTipFunctions, gradients_are_those_of_the_values_on_every_branch) {
  const TipAxes tip{{0.2, -0.1}, {0.8, 0.6}};
  for (const double middle : {0.0, 2.9, -2.9, 3.6, -4.0}) {
    for (const double turn : {-1.1, 0.0, 0.7}) {
      const double angle = middle + turn + std::atan2(0.6, 0.8);
      const Point x = tip.at + Point{0.4 * std::cos(angle), 0.4 * std::sin(angle)};
      const double h = 1e-6;
      const NearTipValues v = near_tip_values(tip, middle, x);
      const Eigen::RowVector4d by_x =
          (near_tip_functions(tip, middle, x + Point{h, 0}) - near_tip_functions(tip, middle, x - Point{h, 0})) /
          (2 * h);
      const Eigen::RowVector4d by_y =
          (near_tip_functions(tip, middle, x + Point{0, h}) - near_tip_functions(tip, middle, x - Point{0, h})) /
          (2 * h);
      EXPECT_LT((v.gradients.row(0) - by_x).norm(), 1e-9) << middle << " " << turn;
      EXPECT_LT((v.gradients.row(1) - by_y).norm(), 1e-9) << middle << " " << turn;
      EXPECT_NEAR(v.values(0), std::sqrt(0.4) * std::cos((middle + turn) / 2), 1e-14);
    }
  }
}

// The field of any K, rotated by any angle, is a sum of the four with two unknowns each.
TEST(NearTipFunctions, span_the_near_tip_field_of_a_body_that_turns) {
  const TipAxes tip{{0, 0}, {1, 0}};
  const PlaneElasticity rock{2.5, 0.22, true};
  const int count = 40;
  Eigen::MatrixXd functions(count, 4), fields(count, 2);
  for (int i = 0; i < count; ++i) {
    const double theta = -3.1 + 6.2 * i / (count - 1), r = 0.3 + 0.01 * i, turn = 0.8;
    functions.row(i) = near_tip_functions(tip, theta, {r * std::cos(theta), r * std::sin(theta)});
    const Eigen::Vector2d u = support::near_tip_displacement(rock, {1.3, -0.7}, r, theta);
    fields.row(i) << std::cos(turn) * u.x() - std::sin(turn) * u.y(), std::sin(turn) * u.x() + std::cos(turn) * u.y();
  }
  const Eigen::MatrixXd weights = (functions.transpose() * functions).ldlt().solve(functions.transpose() * fields);
  EXPECT_LT((functions * weights - fields).norm(), 1e-12 * fields.norm());
}

TEST(TipEnrichment, functions_are_continuous_in_rock_and_jump_across_the_crack) {
  const std::vector<std::pair<const char*, std::vector<std::vector<Point>>>> scenes{
      {"straight", {{{-0.5, 0}, {0.03, 0.02}}}},
      {"kinked near its tip", {{{-0.5, 0}, {-0.05, 0.02}, {0.06, 0.11}}}},
      {"kinked back", {{{-0.5, 0.2}, {0, 0.2}, {0.05, 0.1}, {0, 0.02}}}},
      {"shorter than the radius", {{{-0.04, 0}, {0.05, 0.03}}}},
      {"branched", {{{-0.5, 0}, {0.1, 0.02}}, {{-0.1, 0.0133333}, {0, 0.15}}}},
      {"with a tip near another", {{{-0.5, 0}, {-0.05, 0.02}}, {{0.5, 0.03}, {0.07, 0.01}}}}};
  for (const auto& [name, cracks] : scenes) {
    const Manifold manifold = cracked_square(cracks, 0.1);
    ASSERT_FALSE(manifold.tips.empty()) << name;
    const CoverBasis basis(manifold, CoverFunctions::derived, kWilliams);
    EXPECT_GT(tip_function_count(basis), 0) << name;
    const auto [jump, sides] = greatest_jump(manifold, basis);
    EXPECT_GT(sides, 200) << name;
    EXPECT_LT(jump, 1e-7) << name;  // in thin covers functions are large
  }
}

// Both faces of a crack at a point behind its tip: sin θ/2 is +1 on the left and -1 on the right.
TEST(TipEnrichment, the_faces_of_a_crack_part) {
  const Manifold manifold = cracked_square({{{-0.5, 0}, {0.03, 0}}}, 0.1);
  const CoverBasis basis(manifold, CoverFunctions::derived, kWilliams);
  int seen = 0;
  for (int e = 0; e < basis.element_count(); ++e) {
    const ElementShape shape = basis.shape(e);
    if (shape.tip == nullptr) continue;
    const auto loop = manifold.loop(manifold.elements[static_cast<std::size_t>(e)].outer);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point a = loop[i].position, b = loop[(i + 1) % loop.size()].position;
      if (loop[i].neighbour >= 0 || a.y != 0 || b.y != 0) continue;
      const bool is_above = b.x > a.x;  // the element lies to the left of its edge
      const TipShape::Branch& branch = shape.tip->branches.front();
      const Point x = 0.5 * (a + b);
      const double half = near_tip_functions(branch.tip, branch.middle, x)(1) / std::sqrt(distance(x, branch.tip.at));
      EXPECT_NEAR(half, is_above ? 1 : -1, 1e-12);
      ++seen;
    }
  }
  EXPECT_GE(seen, 6);
}

TEST(TipEnrichment, covers_within_the_radius_carry_functions_and_those_around_gradients) {
  const Manifold manifold = cracked_square({{{-0.5, 0}, {0.03, 0}}}, 0.05);
  TipEnrichment tips(manifold, {TipFunctions::williams, 0.12});
  int carriers = 0;
  for (int c = 0; c < static_cast<int>(manifold.covers.size()); ++c) {
    const int node = manifold.covers[static_cast<std::size_t>(c)].node;
    const double d = distance(manifold.mesh.nodes[static_cast<std::size_t>(node)], {0.03, 0});
    EXPECT_EQ(tips.carries_functions(c), d <= 0.12) << d;
    if (d < 0.12 + 0.05) {
      EXPECT_TRUE(tips.has_own_gradient(c));
    }
    if (d > 0.12 + 0.1) {
      EXPECT_FALSE(tips.has_own_gradient(c));
    }
    carriers += tips.carries_functions(c) ? 1 : 0;
  }
  // In covers cut thin a combination may vanish.
  const int last = tips.number_functions(100);
  EXPECT_LE(last, 100 + 4 * carriers);
  EXPECT_GT(last, 100 + 4 * carriers - 4);
}

}  // namespace keyblock::tip_enrichment_test
