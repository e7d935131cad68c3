// Solutions with near-tip functions: the near-tip field itself, K of an edge crack, and how fast its energy converges.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "cut/bodies/cracks.hpp"
#include "cut/covers/cut_cover.hpp"
#include "cut/mesh/fit_mesh.hpp"
#include "fracture/tip_report.hpp"
#include "step/bodies/linear_static.hpp"
#include "tests/support/continuum_scenes.hpp"

namespace keyblock::tip_functions_test {
namespace {

/// A rectangle with a crack, E 1e5, ν 0.3, plane strain.
Continuum cracked(Point low, Point high, const std::vector<Point>& crack, double side, double radius) {
  BodyGraph graph;
  graph.materials = {0};
  graph.nodes = rectangle_corners(low, high);
  for (int i = 0; i < 4; ++i) graph.pieces.push_back({i, (i + 1) % 4, false, 0, -1, 0});
  CrackPlan plan;
  plan.along = crack;
  add_cracks({&graph, 1}, {&plan, 1}, CracksOutside::are_refused);
  std::vector<Point> tips;
  for (const CrackTip& tip : tips_of(graph)) tips.push_back(tip.at);
  MeshPlan mesh;
  mesh.side = side;
  mesh.angle_deg = 10;
  mesh.through_x = 0.0137;
  mesh.through_y = 0.0071;
  mesh.tip_functions = {TipFunctions::williams, radius};
  Continuum continuum;
  continuum.manifold = cut_cover(graph, fitted_mesh(mesh, graph, tips).mesh);
  continuum.materials = {elastic_material(1e5, 0.3)};
  continuum.plane = Plane::strain;
  continuum.tip_functions = mesh.tip_functions;
  return continuum;
}

struct Found {
  TipReport report;
  double energy = 0;
  int unknowns = 0;
  double residual = 0;
};

Found solved(const Continuum& continuum) {
  const ContinuumSolution solution = solve_static(continuum);
  const CoverSolution view{continuum, solution.basis, solution.solution.x};
  const SparseSystem system = assemble_static(continuum, solution.basis);
  return {tip_report(view, continuum.manifold.tips.front()), 0.5 * solution.solution.x.dot(system.load()),
          solution.unknown_count(), solution.solution.residual};
}

Point pull(Point, Point normal) {
  return {0, normal.y};
}

/// fra-01: a plate 1 by 2 in tension 1, the crack half through it.
Found edge_crack(double side, double radius) {
  Continuum continuum = cracked({0, -1}, {1, 1}, {{0, 0}, {0.5, 0}}, side, radius);
  continuum.tractions = {{{{0, 1}, {1, 1}}, pull}, {{{0, -1}, {1, -1}}, pull}};
  const auto spring = [&](Point at, Point direction) {
    continuum.point_springs.push_back({element_of(continuum.manifold, {at, {}, 0, ""}), at, direction, 1e5});
  };
  spring({1, -1}, {1, 0});
  spring({1, -1}, {0, 1});
  spring({1, 1}, {1, 0});
  return solved(continuum);
}

constexpr double kEdgeCrack = 3.5388220051642585;  // 2.82357 √(π/2), independent finite elements (fra-01)

}  // namespace

// Functions on all covers: the field that they are made for is in their span, whatever the mesh.
TEST(TipFunctions, the_near_tip_field_is_exact) {
  const Point at{0.03, 0.013};
  Continuum continuum = cracked({-0.5, -0.5}, {0.5, 0.5}, {{-0.5, 0.013}, at}, 0.15, 2);
  const PlaneElasticity rock{1e5, 0.3, true};
  const StressIntensity k{1.5, -0.7};
  const auto field = [=](Point x) {
    const Eigen::Vector2d u = near_tip_displacement(rock, k, distance(x, at), std::atan2(x.y - at.y, x.x - at.x));
    return Point{u.x(), u.y()};
  };
  continuum.prescribed = {{{{-0.5, 0.013}, {-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}, {-0.5, 0.013}},
                           Held::both,
                           [=](Point x, Point) { return field(x); }}};
  const ContinuumSolution solution = solve_static(continuum);
  EXPECT_LT(solution.solution.residual, 1e-10);
  const CoverSolution view{continuum, solution.basis, solution.solution.x};
  for (const double outer : {0.2, 0.4}) {
    const CrackTip& tip = continuum.manifold.tips.front();
    const TipFactors f =
        factors_at(view, tip, CrackDomain(continuum.manifold, tip, {DomainKind::circle, outer / 2, outer, 0}));
    EXPECT_NEAR(f.k.mode_1, k.mode_1, 1e-5);
    EXPECT_NEAR(f.k.mode_2, k.mode_2, 1e-5);
    EXPECT_NEAR(f.j, (1.5 * 1.5 + 0.7 * 0.7) / rock.effective_modulus(), 1e-5 * f.j);
  }
  for (int e = 0; e < solution.basis.element_count(); e += 7) {
    const Point x = solution.basis.shape(e).frame.origin;
    if (element_of(continuum.manifold, {x, {}, 0, ""}) != e) continue;
    EXPECT_LT(distance(solution.displacement(e, x), field(x)), 1e-6 * length(field(x))) << x.x << " " << x.y;
  }
}

TEST(TipFunctions, an_edge_crack_is_within_the_error_asked_for) {
  const Found coarse = edge_crack(0.1, 0), fine = edge_crack(0.05, 0);
  ASSERT_TRUE(coarse.report.factors && fine.report.factors);
  EXPECT_NEAR(coarse.report.factors->k.mode_1, kEdgeCrack, 0.005 * kEdgeCrack);
  EXPECT_NEAR(fine.report.factors->k.mode_1, kEdgeCrack, 0.003 * kEdgeCrack);
  EXPECT_LT(std::abs(fine.report.factors->k.mode_2), 0.003 * kEdgeCrack);
  EXPECT_LT(fine.report.spread_1, 0.003);
  EXPECT_LT(fine.residual, 1e-10);
  EXPECT_LE(fine.unknowns, 3000);
}

// The error of the energy norm, √(2 (U - U_h)), falls at least as h^1.5 where functions reach equally far on all
// meshes; where they shrink with the mesh as h^½ (Laborde et al. 2005; Béchet et al. 2005).
TEST(TipFunctions, the_energy_converges_in_a_fixed_radius) {
  constexpr double kEnergy = 2.29942e-5;  // extrapolated from other meshes by an independent program
  std::vector<double> errors;
  for (const double side : {0.1, 0.05, 0.025}) errors.push_back(std::sqrt(kEnergy - edge_crack(side, 0.2).energy));
  const double rate = std::log2(errors.front() / errors.back()) / 2;
  EXPECT_GE(rate, 1.5) << errors[0] << " " << errors[1] << " " << errors[2];
}

}  // namespace keyblock::tip_functions_test
