// The path of equilibria of a bar pressed beyond its limit load, beside its closed form.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/arc_length.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "cut/covers/cut_cover.hpp"
#include "step/rest/share_control.hpp"
#include "tests/support/continuum_scenes.hpp"

namespace keyblock::arc_length_test {
namespace {

constexpr double kModulus = 1000, kLoad = 400;  // of the whole scene, force per length

/// A unit square of four triangles under plane stress, pressed from above. It slides freely along its left and lower
/// edges, and ν = 0: there is no lateral strain.
Continuum pressed_bar(double load) {
  BodyGraph graph;
  graph.materials = {0};
  graph.nodes = rectangle_corners({0, 0}, {1, 1});
  for (int i = 0; i < 4; ++i) graph.pieces.push_back({i, (i + 1) % 4, false, 0, -1, 0});
  const TriangleMesh mesh{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
  Continuum bar;
  bar.manifold = cut_cover(graph, mesh);
  bar.materials = {elastic_material(kModulus, 0)};
  bar.functions = CoverFunctions::constant;
  const auto none = [](Point, Point) { return Point{}; };
  bar.prescribed = {{{{0, 0}, {1, 0}}, Held::y, none}, {{{0, 1}, {0, 0}}, Held::x, none}};
  if (load != 0) bar.tractions = {{{{1, 1}, {0, 1}}, [load](Point, Point) { return Point{0, -load}; }}};
  return bar;
}

/// The fraction of the load that the bar carries at the stretch λ. With Green's strain (λ² - 1)/2 the nominal stress is
/// E λ (λ² - 1)/2, greatest at λ = 1/√3. The shallow truss of von Mises has the same curve over its height.
double share_at(double stretch) {
  return kModulus * stretch * (1 - stretch * stretch) / (2 * kLoad);
}

double stretch_of(const LoadedBodies& bodies, const PathPoint& at) {
  return bodies.elasticity().deformation(at.state.d, 0, {0.5, 0.1})(1, 1);
}

PathPoint start_of(LoadedBodies& bodies) {
  const LoadedState start = bodies.at_start();
  bodies.begin(start, nullptr);
  return {start, 0, Eigen::VectorXd::Zero(start.d.size()), 0};
}

/// Points of the path at this distance from each other, until the bar is as short as `shortest`.
std::vector<PathPoint> path_of(const LoadedBodies& bodies, PathPoint at, double length, double shortest) {
  ArcLength path(bodies);
  std::vector<PathPoint> points;
  while (points.size() < 100 && stretch_of(bodies, at) > shortest) {
    NewtonRounds rounds;
    std::optional<PathPoint> next = path.next(at, length, rounds);
    EXPECT_EQ(rounds.end, RoundsEnd::balanced) << in_words(rounds.end);
    if (!next) break;
    EXPECT_LE(rounds.residuals.back(), tolerances::of_newton::kBalanced);
    EXPECT_EQ(path.last(), next->state.d);
    points.push_back(at = *std::move(next));
  }
  return points;
}

}  // namespace

TEST(ArcLength, a_pressed_bar_is_followed_beyond_its_limit_load) {
  LoadedBodies bodies(pressed_bar(kLoad));
  const PathPoint start = start_of(bodies);
  for (const double length : {0.02, 0.1}) {
    const std::vector<PathPoint> path = path_of(bodies, start, length, 0.3);
    ASSERT_LT(path.size(), 100U);
    double most = 0, before = 1;
    for (const PathPoint& point : path) {
      const double stretch = stretch_of(bodies, point);
      EXPECT_LT(stretch, before);
      before = stretch;
      EXPECT_NEAR(point.share, share_at(stretch), 1e-8) << stretch;
      EXPECT_NEAR(point.way.norm(), length, 1e-12);
      most = std::max(most, point.share);
    }
    EXPECT_NEAR(most, share_at(1 / std::sqrt(3)), 0.3 * length);
    EXPECT_LT(path.back().share, 0.8 * most) << "the load fell";
    EXPECT_LT(path.back().share_change, 0);
  }
}

// Displacement and load fraction are changes since the point before.
TEST(ArcLength, each_point_says_how_it_came_from_the_one_before) {
  LoadedBodies bodies(pressed_bar(kLoad));
  PathPoint before = start_of(bodies);
  for (const PathPoint& point : path_of(bodies, before, 0.1, 0.4)) {
    EXPECT_LT((point.state.d - before.state.d - point.way).norm(), 1e-14);
    EXPECT_NEAR(point.share - before.share, point.share_change, 1e-14);
    before = point;
  }
}

// The last step gives the direction of the next: reversed, the path leads back to where it began.
TEST(ArcLength, a_path_that_is_turned_round_leads_back) {
  LoadedBodies bodies(pressed_bar(kLoad));
  const PathPoint start = start_of(bodies);
  PathPoint at = path_of(bodies, start, 0.1, 0.5).back();
  ASSERT_LT(stretch_of(bodies, at), 1 / std::sqrt(3)) << "beyond the limit load";
  at.way *= -1;
  at.share_change *= -1;
  ArcLength path(bodies);
  double before = stretch_of(bodies, at);
  for (int i = 0; i < 5; ++i) {
    NewtonRounds rounds;
    std::optional<PathPoint> next = path.next(at, 0.1, rounds);
    ASSERT_TRUE(next) << in_words(rounds.end);
    at = *std::move(next);
    const double stretch = stretch_of(bodies, at);
    EXPECT_GT(stretch, before);
    before = stretch;
    EXPECT_NEAR(at.share, share_at(stretch), 1e-8);
  }
  EXPECT_GT(before, 1 / std::sqrt(3));
}

// Elastic answer: u = -(load/E) y at the nodes of all covers. Fixed edges give way by a ten-thousandth of that.
TEST(ArcLength, the_length_of_the_loads_is_that_of_the_elastic_answer) {
  LoadedBodies bodies(pressed_bar(kLoad));
  const PathPoint start = start_of(bodies);
  double squares = 0;
  const Manifold& manifold = bodies.continuum().manifold;
  for (const PhysicalCover& cover : manifold.covers)
    squares += std::pow(kLoad / kModulus * manifold.mesh.nodes[static_cast<std::size_t>(cover.node)].y, 2);
  EXPECT_NEAR(ArcLength(bodies).length_of_loads(start), std::sqrt(squares), 1e-3 * std::sqrt(squares));
}

// The curve continues to λ < 0, where the bar is turned inside out: that is no equilibrium.
TEST(ArcLength, a_bar_is_not_pressed_through_itself) {
  LoadedBodies bodies(pressed_bar(kLoad));
  const PathPoint at = path_of(bodies, start_of(bodies), 0.1, 0.3).back();
  NewtonRounds rounds;
  EXPECT_FALSE(ArcLength(bodies).next(at, 0.8, rounds));
  EXPECT_EQ(rounds.end, RoundsEnd::turned_over) << in_words(rounds.end);
}

TEST(ArcLength, without_loads_there_is_no_path) {
  LoadedBodies bodies(pressed_bar(0));
  const PathPoint start = start_of(bodies);
  ArcLength path(bodies);
  EXPECT_EQ(path.length_of_loads(start), 0);
  EXPECT_EQ(path.last().size(), 0);
  NewtonRounds rounds;
  EXPECT_FALSE(path.next(start, 0.1, rounds));
  EXPECT_EQ(rounds.end, RoundsEnd::off_path);
}

// The path never passes the limit load, and control by load finds no equilibrium beyond it.
TEST(ArcLength, loads_beyond_the_limit_have_no_equilibrium) {
  LoadedBodies bodies(pressed_bar(kLoad));
  const PathPoint start = start_of(bodies);
  const double limit = share_at(1 / std::sqrt(3));
  for (const PathPoint& point : path_of(bodies, start, 0.05, 0.3)) {
    EXPECT_LT(point.share, limit + 1e-9);
    EXPECT_GT(point.share, 0);
  }
  NewtonRounds rounds;
  EXPECT_TRUE(ShareControl(bodies).solve(start.state, start.state.d, 0.95 * limit, rounds));
  EXPECT_FALSE(ShareControl(bodies).solve(start.state, start.state.d, 1.05 * limit, rounds));
}

}  // namespace keyblock::arc_length_test
