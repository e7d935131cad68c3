// Energy, force and tangent of large displacements compared with each other by differences, with the linear stiffness,
// and under rigid motion (benchmark nmm-02).
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/cover_elasticity.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "step/bodies/elastic_bodies.hpp"
#include "terms/cover_stiffness.hpp"
#include "tests/support/continuum_scenes.hpp"

namespace keyblock::cover_elasticity_test {
namespace {

/// The plate of nmm-01 with initial stress, on a mesh rotated by 10°.
ElasticBodies plate(CoverFunctions functions, const Stress& initial = {}, const Stress& per_y = {},
                    ElasticLaw law = ElasticLaw::st_venant_kirchhoff) {
  Continuum continuum;
  MeshSetting mesh{0.06};
  mesh.through = {0.013, 0.007};
  continuum.manifold = cut_body({rectangle_corners({0, 0}, {0.24, 0.12})}, mesh);
  continuum.materials = {elastic_material(1e6, 0.25)};
  continuum.materials[0].initial_stress = initial;
  continuum.materials[0].stress_gradient = per_y;
  continuum.laws = {law};
  continuum.functions = functions;
  return ElasticBodies(continuum);
}

constexpr std::array kLaws{ElasticLaw::st_venant_kirchhoff, ElasticLaw::logarithmic};

constexpr Stress kInitial{3e4, -5e4, 2e4};
constexpr Stress kPerY{1e5, 2e5, -3e5};

/// Unknowns without pattern, of about `size`.
Eigen::VectorXd scattered(int count, double size, double seed) {
  Eigen::VectorXd d(count);
  for (int i = 0; i < count; ++i) d(i) = size * std::sin(seed + 1.7 * i * i);
  return d;
}

Eigen::MatrixXd dense(const SparseSystem& system) {
  return Eigen::MatrixXd(system.lower()).selfadjointView<Eigen::Lower>();
}

SparseSystem empty_like(const SparseSystem& system) {
  SparseSystem copy = system;
  copy.clear();
  return copy;
}

/// Rotated by 1 rad, moved, and deformed by some per cent.
Eigen::VectorXd bent(const ElasticBodies& bodies, double seed) {
  return bodies.rigid.turned(1, {0.05, 0.1}, {0.3, -0.2}) + scattered(bodies.unknown_count(), 1e-3, seed);
}

void for_each_basis_and_law(const std::function<void(CoverFunctions, ElasticLaw)>& look) {
  for (const CoverFunctions functions : kAllCoverFunctions)
    for (const ElasticLaw law : kLaws) look(functions, law);
}

}  // namespace

TEST(CoverElasticity, the_force_is_the_gradient_of_the_energy) {
  for_each_basis_and_law([](CoverFunctions functions, ElasticLaw law) {
    const ElasticBodies bodies = plate(functions, kInitial, kPerY, law);
    const Eigen::VectorXd d = bent(bodies, 1);
    const Eigen::VectorXd along = scattered(bodies.unknown_count(), 1, 2);
    const double h = 1e-6;
    const double difference =
        (bodies.elasticity.energy(d + h * along) - bodies.elasticity.energy(d - h * along)) / (2 * h);
    const double force = bodies.elasticity.force(d, d, 1).dot(along);
    EXPECT_NEAR(force, difference, 1e-6 * bodies.elasticity.force(d, d, 1).norm()) << name_of(functions);
  });
}

TEST(CoverElasticity, the_work_of_a_step_is_the_change_of_energy_and_what_the_weight_loses) {
  for_each_basis_and_law([](CoverFunctions functions, ElasticLaw law) {
    const ElasticBodies bodies = plate(functions, kInitial, kPerY, law);
    const Eigen::VectorXd d0 = bent(bodies, 1);
    const Eigen::VectorXd d1 = bodies.rigid.turned(0.7, {}, {}) + scattered(bodies.unknown_count(), 1e-3, 3);
    const double change = bodies.elasticity.energy(d1) - bodies.elasticity.energy(d0);
    const auto work = [&](double theta) { return bodies.elasticity.force(d0, d1, theta).dot(d1 - d0); };
    EXPECT_NEAR(work(0.5), change, 1e-12 * std::abs(bodies.elasticity.energy(d1))) << name_of(functions);
    // (θ - ½) ∫ Δε : D : Δε is linear in θ and positive.
    EXPECT_GT(work(1), change);
    EXPECT_NEAR(work(1) - change, 2 * (work(0.75) - change), 1e-11 * work(1));
  });
}

TEST(CoverElasticity, a_step_has_no_resultant_and_no_moment_about_its_mean_positions) {
  for_each_basis_and_law([](CoverFunctions functions, ElasticLaw law) {
    const ElasticBodies bodies = plate(functions, kInitial, kPerY, law);
    const Eigen::VectorXd d0 = bent(bodies, 1);
    const Eigen::VectorXd d1 = bodies.rigid.turned(0.7, {}, {}) + scattered(bodies.unknown_count(), 1e-3, 3);
    const Eigen::VectorXd force = bodies.elasticity.force(d0, d1, 0.8);
    const Eigen::Vector3d sums = bodies.rigid.modes(0, (d0 + d1) / 2, {}).transpose() * force;
    EXPECT_LT(sums.norm(), 1e-12 * force.norm()) << name_of(functions);
  });
}

TEST(CoverElasticity, tangents_are_derivatives) {
  for_each_basis_and_law([](CoverFunctions functions, ElasticLaw law) {
    const ElasticBodies bodies = plate(functions, kInitial, kPerY, law);
    const Eigen::VectorXd d = bent(bodies, 1);
    const Eigen::VectorXd along = scattered(bodies.unknown_count(), 1, 2);
    const double h = 1e-7;
    const auto check = [&](const Eigen::VectorXd& plus, const Eigen::VectorXd& minus, const SparseSystem& tangent) {
      const Eigen::VectorXd expected = (plus - minus) / (2 * h);
      EXPECT_LT((tangent.times(along) - expected).norm(), 1e-7 * expected.norm()) << name_of(functions);
    };
    const CoverElasticity& elasticity = bodies.elasticity;
    SparseSystem statics = empty_like(bodies.mass);
    elasticity.add_static_tangent(d, 1, statics);
    const Eigen::VectorXd up = d + h * along;
    const Eigen::VectorXd down = d - h * along;
    check(elasticity.force(up, up, 1), elasticity.force(down, down, 1), statics);
    SparseSystem step = empty_like(bodies.mass);
    elasticity.add_tangent(d, d, 0.8, {}, 1, step);
    check(elasticity.force(d, up, 0.8), elasticity.force(d, down, 0.8), step);
  });
}

// The error of the symmetric tangent is of first order in the step: halved with it.
TEST(CoverElasticity, what_the_symmetric_tangent_leaves_out_falls_with_the_step) {
  const ElasticBodies bodies = plate(CoverFunctions::derived);
  const Eigen::VectorXd along = scattered(bodies.unknown_count(), 1e-3, 2);
  const auto left_out = [&](double angle) {
    const Eigen::VectorXd d0 = bodies.rigid.turned(0, {}, {});
    const Eigen::VectorXd d1 = bodies.rigid.turned(angle, {}, {});
    SparseSystem tangent = empty_like(bodies.mass);
    bodies.elasticity.add_tangent(d0, d1, 1, {}, 1, tangent);
    const double h = 1e-4;
    const Eigen::VectorXd difference =
        (bodies.elasticity.force(d0, d1 + h * along, 1) - bodies.elasticity.force(d0, d1 - h * along, 1)) / (2 * h);
    return (tangent.times(along) - difference).norm() / difference.norm();
  };
  EXPECT_NEAR(left_out(0.02) / left_out(0.01), 2, 0.05);
  EXPECT_LT(left_out(0.01), 0.01);
}

TEST(CoverElasticity, the_tangent_at_the_start_is_the_linear_stiffness) {
  for (const CoverFunctions functions : kAllCoverFunctions) {
    const ElasticBodies bodies = plate(functions);
    SparseSystem linear = empty_like(bodies.mass);
    add_cover_stiffness(bodies.continuum, bodies.basis(), linear);
    SparseSystem tangent = empty_like(bodies.mass);
    bodies.elasticity.add_static_tangent(Eigen::VectorXd::Zero(bodies.unknown_count()), 1, tangent);
    EXPECT_LT((dense(tangent) - dense(linear)).norm(), 1e-13 * dense(linear).norm()) << name_of(functions);
  }
}

// nmm-02: a quarter turn in 90 steps of a degree about a point away from the plate, moved as well.
TEST(CoverElasticity, a_rigid_motion_makes_no_stress_and_no_force) {
  for (const CoverFunctions functions : kAllCoverFunctions) {
    const ElasticBodies bodies = plate(functions);
    Eigen::VectorXd before = Eigen::VectorXd::Zero(bodies.unknown_count());
    for (int step = 1; step <= 90; ++step) {
      const Eigen::VectorXd d =
          bodies.rigid.turned(step * std::numbers::pi / 180, {0.5, -0.3}, {0.01 * step, -0.02 * step});
      // E 1e6 and forces E × 0.24 at most.
      EXPECT_LT(bodies.elasticity.force(before, d, 0.5).norm(), 1e-12 * 1e6 * 0.24) << name_of(functions);
      EXPECT_LT(bodies.ghost.times(d).norm(), 1e-12 * 1e6 * 0.24);
      for (int e = 0; e < bodies.basis().element_count(); ++e) {
        const Point corner = bodies.continuum.manifold.loop(bodies.continuum.manifold.elements[e].outer)[0].position;
        const Stress stress = bodies.elasticity.stress(d, e, corner);
        EXPECT_LT(std::abs(stress.xx) + std::abs(stress.yy) + std::abs(stress.xy), 1e-12 * 1e6);
        EXPECT_NEAR(bodies.elasticity.deformation(d, e, corner).determinant(), 1, 1e-12) << "area";
      }
      before = d;
    }
  }
}

// Stretched by a linear field, then rotated by 1 rad: the Cauchy stress rotates with the body.
TEST(CoverElasticity, a_uniform_stress_turns_with_the_body) {
  for (const CoverFunctions functions : kAllCoverFunctions) {
    const ElasticBodies bodies = plate(functions, kInitial);
    const double sx = 1.01;
    const double sy = 0.99;
    const double c = std::cos(1.0);
    const double s = std::sin(1.0);
    // x = R diag(sx, sy) X in the unknowns: positions are functions of the covers.
    Eigen::VectorXd d(bodies.unknown_count());
    for (int f = 0; 2 * f < d.size(); ++f) {
      const Eigen::Vector2d start = bodies.rigid.start().segment<2>(2 * f);
      d.segment<2>(2 * f) << c * sx * start(0) - s * sy * start(1) - start(0),
          s * sx * start(0) + c * sy * start(1) - start(1);
    }
    const double ex = (sx * sx - 1) / 2;
    const double ey = (sy * sy - 1) / 2;
    const double per = 1e6 / (1 - 0.25 * 0.25);
    Eigen::Matrix2d second;  // S of plane stress
    second << kInitial.xx + per * (ex + 0.25 * ey), kInitial.xy, kInitial.xy, kInitial.yy + per * (ey + 0.25 * ex);
    Eigen::Matrix2d f;
    f << c * sx, -s * sy, s * sx, c * sy;
    const Eigen::Matrix2d expected = f * second * f.transpose() / (sx * sy);
    for (int e = 0; e < bodies.basis().element_count(); ++e) {
      const Point corner = bodies.continuum.manifold.loop(bodies.continuum.manifold.elements[e].outer)[0].position;
      const Stress stress = bodies.elasticity.stress(d, e, corner);
      EXPECT_NEAR(stress.xx, expected(0, 0), 1e-6) << name_of(functions);
      EXPECT_NEAR(stress.yy, expected(1, 1), 1e-6);
      EXPECT_NEAR(stress.xy, expected(0, 1), 1e-6);
      const Point at = bodies.elasticity.position(d, e, corner);
      EXPECT_NEAR(at.x, c * sx * corner.x - s * sy * corner.y, 1e-14);
      EXPECT_NEAR(at.y, s * sx * corner.x + c * sy * corner.y, 1e-14);
    }
  }
}

}  // namespace keyblock::cover_elasticity_test
