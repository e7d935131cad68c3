// Loads along chains: exactly the covered part of an edge carries its load.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/cover_loads.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "cut/covers/to_cover.hpp"
#include "geometry/quadrature.hpp"
#include "geometry/segment.hpp"
#include "run/bodies/planned_bodies.hpp"
#include "step/bodies/linear_static.hpp"
#include "tests/support/continuum_scenes.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::cover_loads_test {
namespace {

using Loop = std::vector<Point>;

/// A body with a reflex corner, a slanting edge, a hole, and a crack that ends inside. Every edge belongs to a loop,
/// with the body to its left; both faces of the crack form one loop.
const std::vector<Loop> kLoops{{{0, 0}, {3, 0}, {3, 1.7}, {1.9, 2.3}, {1.1, 1.2}, {0, 1.4}},
                               {{0.6, 0.4}, {0.7, 0.9}, {1.3, 0.8}, {1.1, 0.3}},
                               {{1.6, 0.4}, {2.8, 1}, {1.6, 0.4}}};
constexpr std::size_t kCrack = 2;

Point turned(Point p, double angle, Point shift) {
  return shift + Point{std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y};
}

/// The bodies on a mesh of one kind, turned and moved.
struct Body {
  std::vector<Loop> loops = kLoops;
  Manifold manifold;
};

enum class Kind { regular, aligned, unstructured, bisected, file };

Problem problem_of(const std::vector<Loop>& loops, Kind kind) {
  Problem problem;
  Blocks blocks;
  BlockPolygon block;
  for (const Point p : loops[0]) block.outer.push_back({p, 0});
  block.holes.emplace_back();
  for (const Point p : loops[1]) block.holes.back().push_back({p, 0});
  blocks.blocks = {block};
  problem.geometry = blocks;
  problem.analysis = support::plain_analysis(1, 1);
  CoverPlan plan;
  plan.mesh.side = 0.31;
  plan.mesh.angle_deg = kind == Kind::aligned ? 0 : 10;
  if (kind == Kind::unstructured) plan.mesh.kind = MeshKind::unstructured;
  if (kind == Kind::aligned || kind == Kind::unstructured) plan.mesh.placement = MeshPlacement::aligned;
  if (kind == Kind::bisected || kind == Kind::file) plan.mesh.tip_side = 0.02;
  if (kind == Kind::bisected) plan.mesh.refined = {{loops[0][1], 0.05}};
  plan.cracks.emplace_back().along = {loops[kCrack][0], loops[kCrack][1]};
  problem.covers = plan;
  return problem;
}

Body body_on(Kind kind, double angle, Point shift) {
  Body body;
  for (Loop& loop : body.loops)
    for (Point& p : loop) p = turned(p, angle, shift);
  const Problem problem = problem_of(body.loops, kind);
  const PlannedBodies bodies(problem);
  body.manifold = bodies.at(0);
  if (kind != Kind::file) return body;
  Problem from_file = problem;
  from_file.geometry = to_cover(body.manifold, bodies.blocks());
  from_file.covers->mesh = {};
  from_file.covers->cracks.clear();
  body.manifold = PlannedBodies(from_file).at(0);
  return body;
}

Continuum continuum_on(const Body& body, CoverFunctions functions) {
  Continuum continuum;
  continuum.manifold = body.manifold;
  continuum.materials = {elastic_material(1e6, 0.25)};
  continuum.functions = functions;
  return continuum;
}

/// Cubic in places, and a pressure: loads that a quadrature must integrate exactly.
Point load_at(Point x, Point n) {
  const double a = x.x - 100, b = x.y;
  return Point{1 + a - b * b, 0.5 - 2 * a * b} - (2 + a) * n;
}

/// Sum of a load along one straight piece, with its normal to the right of its direction.
Resultant along_piece(Point from, Point to, Point normal) {
  Resultant sum;
  for (const GaussPoint& g : gauss_rule(4)) {
    const Point x = point_at({from, to}, g.at);
    sum.add(x, g.weight * distance(from, to) * load_at(x, normal));
  }
  return sum;
}

/// A chain along a loop, and the exact sum of the load on it.
struct Chain {
  BoundaryPart along;
  Resultant exact;
};

/// Begins and ends anywhere, ends at corners at times, has points within edges, and runs either way.
Chain random_chain(const std::vector<Loop>& loops, std::mt19937& random) {
  const auto share = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
  const auto k = std::uniform_int_distribution<std::size_t>(0, loops.size() - 1)(random);
  const Loop& loop = loops[k];
  const auto n = k == kCrack ? std::size_t{1} : loop.size();
  const auto first = std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  const auto edges = std::uniform_int_distribution<std::size_t>(1, n)(random);
  double begin = share() < 0.2 ? 0 : share(), end = share() < 0.2 ? 1 : share();
  if (k == kCrack) {  // of a tip without a node the last piece, inside an element, is no boundary
    begin = 0.3 + 0.4 * share();
    end = 0.3 + 0.4 * share();
  }
  if (edges == 1 && begin > end) std::swap(begin, end);
  Chain chain;
  for (std::size_t i = 0; i < edges; ++i) {
    const Segment edge{loop[(first + i) % loop.size()], loop[(first + i + 1) % loop.size()]};
    const double from = i == 0 ? begin : 0, to = i + 1 == edges ? end : 1;
    const Point start = from == 0 ? edge.start : point_at(edge, from), stop = to == 1 ? edge.end : point_at(edge, to);
    if (i == 0) chain.along.push_back(start);
    for (double at = from; share() < 0.3;) chain.along.push_back(point_at(edge, at += share() * (to - at)));
    chain.along.push_back(stop);
    const Point along = (1 / distance(edge.start, edge.end)) * (edge.end - edge.start);
    const Point normal{along.y, -along.x};
    chain.exact.add(along_piece(start, stop, normal));
    if (k == kCrack) chain.exact.add(along_piece(start, stop, -1.0 * normal));
  }
  if (share() < 0.5) std::ranges::reverse(chain.along);
  return chain;
}

/// Work of the assembled load on rigid motions: of functions whose unknowns are displacements of nodes.
Resultant over_rigid_motions(const Continuum& continuum, const CoverBasis& basis, const Eigen::VectorXd& load) {
  Resultant sum;
  for (int f = 0; f < basis.function_count(); ++f) {
    const PhysicalCover& cover = continuum.manifold.covers[static_cast<std::size_t>(f)];
    sum.add(continuum.manifold.mesh.nodes[static_cast<std::size_t>(cover.node)], {load(2 * f), load(2 * f + 1)});
  }
  return sum;
}

void expect_same(const Resultant& found, const Resultant& exact, double scale, Point centre, const std::string& what) {
  const auto about = [&](const Resultant& of) { return of.moment - cross(centre, of.force); };
  EXPECT_NEAR(found.force.x, exact.force.x, 1e-12 * scale) << what;
  EXPECT_NEAR(found.force.y, exact.force.y, 1e-12 * scale) << what;
  EXPECT_NEAR(about(found), about(exact), 1e-12 * scale) << what;
}

constexpr Kind kKinds[] = {Kind::regular, Kind::aligned, Kind::unstructured, Kind::bisected, Kind::file};

}  // namespace

TEST(CoverLoads, a_chain_that_begins_ends_and_bends_anywhere_bears_the_exact_integral_of_its_load) {
  std::mt19937 random(50);
  for (const Kind kind : kKinds) {
    const Body body = body_on(kind, 0.3, {100, -2});
    for (const CoverFunctions functions : {CoverFunctions::constant, CoverFunctions::derived}) {
      const Continuum continuum = continuum_on(body, functions);
      const CoverBasis basis = basis_of(continuum);
      for (int i = 0; i < 50; ++i) {
        const Chain chain = random_chain(body.loops, random);
        SparseSystem system(basis.function_count(), {});
        add_traction(continuum, basis, {chain.along, load_at}, system);
        expect_same(over_rigid_motions(continuum, basis, system.load()), chain.exact, 30, {100, -2},
                    fmt::format("mesh {}, chain {}", static_cast<int>(kind), i));
      }
    }
  }
}

TEST(CoverLoads, chains_over_one_another_add_up_and_a_chain_that_turns_back_counts_once) {
  const Body body = body_on(Kind::regular, 0, {0, 0});
  const auto even = [](Point, Point) { return Point{0, -1}; };
  Continuum continuum = continuum_on(body, CoverFunctions::derived);
  continuum.tractions = {
      {{{0.37, 0}, {1.6, 0}}, even}, {{{1.1, 0}, {2.9, 0}}, even}, {{{0.2, 0}, {0.9, 0}, {0.5, 0}, {1.3, 0}}, even}};
  EXPECT_NEAR(sum_of_loads(continuum, 1).force.y, -(1.23 + 1.8 + 1.1), 1e-12);
}

TEST(CoverLoads, a_piece_of_a_chain_that_leaves_the_boundary_bears_nothing) {
  const Body body = body_on(Kind::regular, 0, {0, 0});
  Continuum continuum = continuum_on(body, CoverFunctions::derived);
  // From the lower edge across the body to the right one, and beyond its upper end.
  continuum.tractions = {{{{2.2, 0}, {2.65, 0}, {3, 0.35}, {3, 1.9}}, [](Point, Point) { return Point{1, 0}; }}};
  EXPECT_NEAR(sum_of_loads(continuum, 1).force.x, 0.45 + 1.35, 1e-12);
}

// Fixed on parts of edges and loaded by the stress of the field on the others: where one part ends and the next begins,
// a linear field stays exact.
TEST(CoverLoads, edges_held_in_part_and_loaded_in_part_leave_a_linear_field_exact) {
  const auto field = [](Point p) { return Point{1e-3 * (p.x + p.y / 2), 1e-3 * (p.y + p.x / 2)}; };
  std::mt19937 random(51);
  for (const CoverFunctions functions : kAllCoverFunctions) {
    Continuum continuum;
    const Loop corners = rectangle_corners({0, 0}, {0.24, 0.12});
    continuum.manifold = cut_body({corners}, {0.04});
    continuum.materials = {elastic_material(1e6, 0.25)};
    continuum.plane = Plane::stress;
    continuum.functions = functions;
    const Eigen::Vector3d stress = continuum.modulus(0) * Eigen::Vector3d(1e-3, 1e-3, 1e-3);
    const auto drawn = [stress](Point, Point n) {
      return Point{stress(0) * n.x + stress(2) * n.y, stress(2) * n.x + stress(1) * n.y};
    };
    for (std::size_t i = 0; i < 4; ++i) {
      const Segment edge{corners[i], corners[(i + 1) % 4]};
      const double at = std::uniform_real_distribution<double>(0.2, 0.8)(random);
      continuum.prescribed.push_back({{edge.start, point_at(edge, at)}, Held::both, at_any_normal(field)});
      continuum.tractions.push_back({{point_at(edge, at), edge.end}, drawn});
    }
    const ContinuumSolution solution = solve_static(continuum);
    for (const Point p : {Point{0.01, 0.01}, Point{0.2, 0.1}, Point{0.24, 0.12}, Point{0.1, 0.06}})
      EXPECT_LT(distance(displacement_at(continuum, solution, p), field(p)), 1e-14) << name_of(functions);
  }
}

}  // namespace keyblock::cover_loads_test
