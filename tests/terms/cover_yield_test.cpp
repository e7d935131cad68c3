// Rock that may yield on covers: homogeneous strain, tangents against differences, rigid motion, what a cover gathers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/cover_yield.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "step/bodies/elastic_bodies.hpp"
#include "terms/cover_elasticity.hpp"
#include "tests/support/continuum_scenes.hpp"

namespace keyblock::cover_yield_test {
namespace {

constexpr double kWidth = 0.24, kHeight = 0.12;

Strength friction(double cohesion, double friction_deg, double dilation_deg) {
  Strength s;
  s.values = {.cohesion = cohesion, .friction_deg = friction_deg, .dilation_deg = dilation_deg};
  return s;
}

/// The plate of nmm-01 on a mesh turned by 10°, cut at random.
struct Plate {
  Continuum continuum;
  CoverBasis basis;
  CoverYield yield;

  Plate(CoverFunctions functions, const Strength& strength, Plane plane = Plane::strain, const Stress& initial = {})
      : continuum(made(functions, strength, plane, initial)),
        basis(continuum.manifold, functions),
        yield(continuum, basis) {}

  static Continuum made(CoverFunctions functions, const Strength& strength, Plane plane, const Stress& initial) {
    Continuum continuum;
    MeshSetting mesh{0.06};
    mesh.through = {0.013, 0.007};
    continuum.manifold = cut_body({rectangle_corners({0, 0}, {kWidth, kHeight})}, mesh);
    continuum.materials = {elastic_material(1e6, 0.25)};
    continuum.materials[0].initial_stress = initial;
    continuum.materials[0].strength = std::make_shared<const Strength>(strength);
    continuum.functions = functions;
    continuum.plane = plane;
    return continuum;
  }

  /// u = H X on constant functions.
  Eigen::VectorXd homogeneous(const Eigen::Matrix2d& h) const {
    Eigen::VectorXd d(2 * basis.function_count());
    for (int f = 0; f < basis.function_count(); ++f) {
      const Point node =
          continuum.manifold.mesh
              .nodes[static_cast<std::size_t>(continuum.manifold.covers[static_cast<std::size_t>(f)].node)];
      d.segment<2>(2 * f) = h * Eigen::Vector2d(node.x, node.y);
    }
    return d;
  }
};

Eigen::VectorXd scattered(Eigen::Index count, double size, double seed) {
  Eigen::VectorXd d(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto k = static_cast<double>(i);
    d(i) = size * std::sin(seed + 1.7 * k * k);
  }
  return d;
}

double yielding_share(const YieldStates& states) {
  const auto yields = [](const YieldState& state) { return state.region != YieldRegion::elastic; };
  return static_cast<double>(std::ranges::count_if(states, yields)) / static_cast<double>(states.size());
}

WholeSystem system_of(const Plate& plate) {
  FunctionGroups groups;
  plate.yield.add_groups(groups);
  return {plate.basis.function_count(), groups};
}

}  // namespace

// All covers see the same gradient: stress is the law's, virtual work that of the area.
TEST(CoverYield, homogeneous_strain_has_the_stress_of_one_point) {
  const Plate plate(CoverFunctions::constant, friction(1000, 30, 10));
  Eigen::Matrix2d h;
  h << 2e-3, 1e-3, -1e-3, -8e-3;
  const Eigen::VectorXd none = plate.homogeneous(Eigen::Matrix2d::Zero());
  const Eigen::VectorXd d = plate.homogeneous(h);
  const CoverYield::Answer answer = plate.yield.answer(none, plate.yield.start(), d);
  const Eigen::Matrix2d f = Eigen::Matrix2d::Identity() + h;
  const Eigen::Matrix2d green = (f.transpose() * f - Eigen::Matrix2d::Identity()) / 2;
  const Eigen::Vector3d strain = log_strain({green(0, 0), green(1, 1), 2 * green(0, 1)});
  const YieldLaw law{1e6, 0.25, friction(1000, 30, 10)};
  const Response point = respond(law, {strain(0), strain(1), strain(2), 0}, {}, 1);
  ASSERT_NE(point.after.region, YieldRegion::elastic);
  for (const YieldState& state : answer.after) EXPECT_LT((state.elastic - point.after.elastic).norm(), 1e-14);
  for (const YieldState& state : answer.after) EXPECT_EQ(state.region, point.after.region);
  // Virtual work of a homogeneous field: area times S : Fᵀ δH.
  const Eigen::Vector3d second =
      log_strain_rate({green(0, 0), green(1, 1), 2 * green(0, 1)}).transpose() * point.stress.head<3>();
  Eigen::Matrix2d s, change;
  s << second(0), second(2), second(2), second(1);
  change << 0.3, -0.2, 0.5, 0.7;
  const double work = kWidth * kHeight * (f * s).cwiseProduct(change).sum();
  EXPECT_NEAR(answer.force.dot(plate.homogeneous(change)), work, 1e-11 * std::abs(work));
}

TEST(CoverYield, the_tangent_is_the_derivative_of_the_force) {
  for (const CoverFunctions functions : {CoverFunctions::constant, CoverFunctions::derived, CoverFunctions::linear})
    for (const Plane plane : {Plane::strain, Plane::stress}) {
      const Plate plate(functions, friction(1000, 30, 10), plane, {500, -300, 200});
      const Eigen::Index count = 2 * plate.basis.function_count();
      const Eigen::VectorXd d0 = scattered(count, 2e-5, 0.3);
      const Eigen::VectorXd d1 = d0 + scattered(count, 2e-4, 0.9);
      const YieldStates before = plate.yield.answer(0 * d0, plate.yield.start(), d0).after;
      WholeSystem system = system_of(plate);
      plate.yield.add_tangent(d0, before, d1, 0, system);
      const YieldStates after = plate.yield.answer(d0, before, d1).after;
      EXPECT_GT(yielding_share(after), 0.3);
      const Eigen::VectorXd way = scattered(count, 1, 2.1);
      constexpr double kStep = 1e-10;
      const CoverYield::Answer forth = plate.yield.answer(d0, before, d1 + kStep * way);
      const CoverYield::Answer back = plate.yield.answer(d0, before, d1 - kStep * way);
      const Eigen::VectorXd difference = (forth.force - back.force) / (2 * kStep);
      EXPECT_LT((difference - system.matrix() * way).norm(), 1e-5 * difference.norm());
    }
}

TEST(CoverYield, a_body_that_turns_bears_nothing_and_turned_stress_turns_with_it) {
  const Plate plate(CoverFunctions::constant, friction(1000, 30, 10), Plane::strain, {-500, -300, 200});
  Eigen::Matrix2d turn;
  turn << std::cos(1.0) - 1, -std::sin(1.0), std::sin(1.0), std::cos(1.0) - 1;
  const Eigen::VectorXd none = plate.homogeneous(Eigen::Matrix2d::Zero());
  const Eigen::VectorXd d = plate.homogeneous(turn);
  const CoverYield::Answer answer = plate.yield.answer(none, plate.yield.start(), d);
  for (const YieldState& state : answer.after) EXPECT_EQ(state.region, YieldRegion::elastic);
  const Stress stress = plate.yield.stress(d, answer.after, 0, {0.1, 0.05});
  const Eigen::Matrix2d r = turn + Eigen::Matrix2d::Identity();
  Eigen::Matrix2d initial;
  initial << -500, 200, 200, -300;
  const Eigen::Matrix2d turned = r * initial * r.transpose();
  EXPECT_NEAR(stress.xx, turned(0, 0), 1e-9);
  EXPECT_NEAR(stress.yy, turned(1, 1), 1e-9);
  EXPECT_NEAR(stress.xy, turned(0, 1), 1e-9);
  EXPECT_NEAR(stress.zz, 0.25 * -800, 1e-9);
}

// Forces inside a body have no resultant, whatever its points do.
TEST(CoverYield, forces_add_up_to_nothing) {
  const Plate plate(CoverFunctions::constant, friction(1000, 30, 0));
  const Eigen::Index count = 2 * plate.basis.function_count();
  const Eigen::VectorXd d = scattered(count, 3e-4, 0.4);
  const Eigen::VectorXd force = plate.yield.answer(0 * d, plate.yield.start(), d).force;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (Eigen::Index f = 0; f < count / 2; ++f) sum += force.segment<2>(2 * f);
  EXPECT_LT(sum.norm(), 1e-12 * force.norm());
}

TEST(CoverYield, rock_without_a_strength_is_left_to_its_elasticity) {
  Plate plate(CoverFunctions::constant, friction(1000, 30, 10));
  plate.continuum.materials[0].strength = nullptr;
  const CoverYield none(plate.continuum, plate.basis);
  EXPECT_TRUE(none.is_empty());
  const Plate yields(CoverFunctions::constant, friction(1000, 30, 10));
  const CoverElasticity elastic(yields.continuum, yields.basis);
  EXPECT_EQ(elastic.energy(scattered(2 * yields.basis.function_count(), 1e-3, 1)), 0);
}

}  // namespace keyblock::cover_yield_test
