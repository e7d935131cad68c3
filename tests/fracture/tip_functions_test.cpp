// Solutions with near-tip functions: the near-tip field itself, K of an edge crack, convergence of its energy, and tips
// that contact closes.
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
Continuum edge_cracked(double side, double radius) {
  Continuum continuum = cracked({0, -1}, {1, 1}, {{0, 0}, {0.5, 0}}, side, radius);
  continuum.tractions = {{{{0, 1}, {1, 1}}, pull}, {{{0, -1}, {1, -1}}, pull}};
  const auto spring = [&](Point at, Point direction) {
    continuum.point_springs.push_back({element_of(continuum.manifold, {at, {}, 0, ""}), at, direction, 1e5});
  };
  spring({1, -1}, {1, 0});
  spring({1, -1}, {0, 1});
  spring({1, 1}, {1, 0});
  return continuum;
}

Found edge_crack(double side, double radius) {
  return solved(edge_cracked(side, radius));
}

constexpr double kEdgeCrack = 3.5388220051642585;  // 2.82357 √(π/2), independent finite elements (fra-01)

}  // namespace

// Functions on all covers: the near-tip field is in their span, on any mesh.
TEST(TipFunctions, the_near_tip_field_is_exact) {
  const Point at{0.03, 0.013};
  Continuum continuum = cracked({-0.5, -0.5}, {0.5, 0.5}, {{-0.5, 0.013}, at}, 0.15, 2);
  const PlaneElasticity rock{1e5, 0.3, true};
  const StressIntensity k{1.5, -0.7};
  const auto traction = [=](Point x, Point n) {
    const Eigen::Vector3d s = near_tip_stress(k, distance(x, at), std::atan2(x.y - at.y, x.x - at.x));
    return Point{s(0) * n.x + s(2) * n.y, s(2) * n.x + s(1) * n.y};
  };
  continuum.tractions = {
      {{{-0.5, 0.013}, {-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}, {-0.5, 0.013}}, traction}};
  const auto spring = [&](Point p, Point direction) {
    continuum.point_springs.push_back({element_of(continuum.manifold, {p, {}, 0, ""}), p, direction, 1e5});
  };
  spring({0.5, -0.5}, {1, 0});
  spring({0.5, -0.5}, {0, 1});
  spring({0.5, 0.5}, {1, 0});
  const ContinuumSolution solution = solve_static(continuum);
  EXPECT_LT(solution.solution.residual, 1e-8);
  const TipReport report =
      tip_report({continuum, solution.basis, solution.solution.x}, continuum.manifold.tips.front());
  ASSERT_TRUE(report.factors);
  EXPECT_NEAR(report.factors->k.mode_1, k.mode_1, 2e-4);
  EXPECT_NEAR(report.factors->k.mode_2, k.mode_2, 2e-4);
  EXPECT_NEAR(report.factors->j, (1.5 * 1.5 + 0.7 * 0.7) / rock.effective_modulus(), 2e-4 * report.factors->j);
  int seen = 0;
  for (int e = 0; e < solution.basis.element_count(); ++e) {
    const Point x = solution.basis.shape(e).frame.origin;
    if (element_of(continuum.manifold, {x, {}, 0, ""}) != e || distance(x, at) < 0.01) continue;
    const Eigen::Vector3d s = near_tip_stress(k, distance(x, at), std::atan2(x.y - at.y, x.x - at.x));
    const Eigen::Vector3d found = continuum.modulus(e) * solution.strain(e, x);
    EXPECT_LT((found - s).norm(), 1e-3 * s.norm()) << x.x << " " << x.y;
    ++seen;
  }
  EXPECT_GT(seen, 40);
}

TEST(TipFunctions, an_edge_crack_is_within_the_error_asked_for) {
  const Found coarse = edge_crack(0.1, 0), fine = edge_crack(0.05, 0);
  ASSERT_TRUE(coarse.report.factors && fine.report.factors);
  EXPECT_NEAR(coarse.report.factors->k.mode_1, kEdgeCrack, 0.005 * kEdgeCrack);
  EXPECT_NEAR(fine.report.factors->k.mode_1, kEdgeCrack, 0.003 * kEdgeCrack);
  EXPECT_LT(std::abs(fine.report.factors->k.mode_2), 0.003 * kEdgeCrack);
  EXPECT_LT(fine.report.spread_1, 0.003);
  EXPECT_LT(fine.residual, 1e-10);
  EXPECT_LE(coarse.unknowns, 3000);
}

// Energies of meshes, each twice as fine as the one before, rise towards a limit as U - C h^2p: their differences fall
// by 4^p, p the rate of the energy norm. It is above 1.5 if functions reach equally far on all meshes; if they shrink
// with the mesh it is a half (Laborde et al. 2005; Béchet et al. 2005).
TEST(TipFunctions, the_energy_converges_in_a_fixed_radius) {
  std::vector<double> energies;
  for (const double side : {0.1, 0.05, 0.025}) energies.push_back(edge_crack(side, 0.2).energy);
  const double first = energies[1] - energies[0], second = energies[2] - energies[1];
  ASSERT_GT(second, 0);
  EXPECT_GE(std::log2(first / second) / 2, 1.5) << first << " " << second;
}

// Contact that presses the faces together at the tip leaves no K_I. Its value from the integral is taken out of K_II in
// proportion to the forces. A force that cannot explain an opening, or of another body, closes nothing.
TEST(ClosedTip, is_one_whose_own_faces_press_as_hard_as_k_says) {
  const Continuum continuum = edge_cracked(0.1, 0);
  const ContinuumSolution solution = solve_static(continuum);
  const CrackTip& tip = continuum.manifold.tips.front();
  const double side = solution.basis.shape(element_of(continuum.manifold, tip)).frame.size;
  const CrackDomain domain(continuum.manifold, tip, {DomainKind::circle, 0.2, 0.4, 0});
  const auto element_at = [&](double x, double y) { return element_of(continuum.manifold, {{x, y}, {}, 0, ""}); };
  const auto factors = [&](double share, Point force, bool is_of_faces) {
    const Eigen::VectorXd d = share * solution.solution.x;
    CoverSolution view{continuum, solution.basis, d};
    for (const double r : {0.5 * side, 1.5 * side, 3 * side}) {
      const int left = element_at(0.5 - r, 1e-6), right = element_at(0.5 - r, -1e-6);
      view.face_forces.push_back({left, {0.5 - r, 0}, force, is_of_faces ? right : -1});
      view.face_forces.push_back({right, {0.5 - r, 0}, -1.0 * force, is_of_faces ? left : -1});
    }
    return factors_at(view, tip, domain);
  };
  const Point force{-4, 10};
  // Part of the field, so that it and the forces leave a K_I of 1.
  const double share = (1 - factors(0, force, false).k.mode_1) / kEdgeCrack;
  const TipFactors open = factors(share, force, false);
  EXPECT_FALSE(open.is_closed);
  EXPECT_NEAR(open.k.mode_1, 1, 0.01 * std::abs(share) * kEdgeCrack);
  const TipFactors closed = factors(share, force, true);
  EXPECT_TRUE(closed.is_closed);
  EXPECT_EQ(closed.k.mode_1, 0);
  EXPECT_NEAR(closed.k.mode_2, open.k.mode_2 - force.x / force.y * open.k.mode_1, 1e-9);
  const TipFactors hardly = factors(1, {0, 1e-9}, true);
  EXPECT_FALSE(hardly.is_closed);
  EXPECT_NEAR(hardly.k.mode_1, kEdgeCrack, 0.01 * kEdgeCrack);
  EXPECT_FALSE(factors(share, {0, -10}, true).is_closed) << "faces that pull each other";
}

// Faces pressed a little behind the tip alone are closed if K_I would make them overlap, and open if not.
TEST(ClosedTip, does_not_overlap_where_faces_press_behind_it) {
  const Continuum continuum = edge_cracked(0.1, 0);
  const ContinuumSolution solution = solve_static(continuum);
  const CrackTip& tip = continuum.manifold.tips.front();
  const double side = solution.basis.shape(element_of(continuum.manifold, tip)).frame.size;
  const CrackDomain domain(continuum.manifold, tip, {DomainKind::circle, 0.2, 0.4, 0});
  const Point at{0.5 - 3 * side, 0};
  const auto element_at = [&](double y) { return element_of(continuum.manifold, {{at.x, y}, {}, 0, ""}); };
  const int left = element_at(1e-6), right = element_at(-1e-6);
  const auto factors = [&](double share, double pressure) {
    const Eigen::VectorXd d = share * solution.solution.x;
    CoverSolution view{continuum, solution.basis, d};
    view.face_forces = {{left, at, {0, pressure}, right}, {right, at, {0, -pressure}, left}};
    return factors_at(view, tip, domain);
  };
  const double of_forces = factors(0, 1).k.mode_1;
  const TipFactors overlapping = factors((-0.1 - of_forces) / kEdgeCrack, 1);
  EXPECT_TRUE(overlapping.is_closed);
  EXPECT_EQ(overlapping.k.mode_1, 0);
  const TipFactors opening = factors((0.1 - of_forces) / kEdgeCrack, 1);
  EXPECT_FALSE(opening.is_closed);
  EXPECT_NEAR(opening.k.mode_1, 0.1, 0.01);
}

}  // namespace keyblock::tip_functions_test
