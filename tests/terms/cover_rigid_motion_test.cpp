// Mass, centre, rotary inertia and momenta of a rectangle against closed forms, in every kind of cover functions.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/cover_rigid_motion.hpp"

#include <gtest/gtest.h>

#include "step/bodies/elastic_bodies.hpp"
#include "tests/support/continuum_scenes.hpp"

namespace keyblock::cover_rigid_motion_test {
namespace {

constexpr double kDensity = 2500;

ElasticBodies rectangle(CoverFunctions functions) {
  Continuum continuum;
  continuum.manifold = cut_body({rectangle_corners({1, 2}, {3, 3})}, MeshSetting{0.5});
  continuum.materials = {elastic_material(1e6, 0.25)};
  continuum.materials[0].density = kDensity;
  continuum.materials[0].unit_weight = 9.81 * kDensity;
  continuum.functions = functions;
  return ElasticBodies(continuum);
}

}  // namespace

TEST(CoverRigidMotion, mass_centre_and_inertia_of_a_rectangle_turned_about_a_corner) {
  for (const CoverFunctions functions : kAllCoverFunctions) {
    const ElasticBodies bodies = rectangle(functions);
    const Eigen::VectorXd d = bodies.rigid.turned(0.5, {1, 2}, {10, 0});
    const Point arm{std::cos(0.5) - 0.5 * std::sin(0.5), std::sin(0.5) + 0.5 * std::cos(0.5)};
    const RigidMotion motion = bodies.rigid.motions(d, 0 * d)[0];
    EXPECT_NEAR(motion.mass, 2 * kDensity, 1e-12 * motion.mass) << name_of(functions);
    EXPECT_NEAR(motion.centre.x, 11 + arm.x, 1e-12);
    EXPECT_NEAR(motion.centre.y, 2 + arm.y, 1e-12);
    EXPECT_NEAR(motion.rotary_inertia, 2 * kDensity * 5 / 12, 1e-11 * motion.rotary_inertia);
  }
}

TEST(CoverRigidMotion, momenta_and_energy_of_rigid_velocities) {
  for (const CoverFunctions functions : kAllCoverFunctions) {
    const ElasticBodies bodies = rectangle(functions);
    const Eigen::VectorXd d = bodies.rigid.turned(0.5, {1, 2}, {10, 0});
    const Point centre = bodies.rigid.motions(d, 0 * d)[0].centre;
    const Eigen::VectorXd v = bodies.rigid.modes(0, d, centre) * Eigen::Vector3d(3, -4, 2);
    const RigidMotion motion = bodies.rigid.motions(d, v)[0];
    const double mass = 2 * kDensity;
    const double inertia = mass * 5 / 12;
    EXPECT_NEAR(motion.momentum.x, 3 * mass, 1e-11 * mass) << name_of(functions);
    EXPECT_NEAR(motion.momentum.y, -4 * mass, 1e-11 * mass);
    EXPECT_NEAR(motion.angular_momentum, 2 * inertia, 1e-11 * inertia);
    EXPECT_NEAR(motion.kinetic_energy, 12.5 * mass + 2 * inertia, 1e-11 * mass);
  }
}

TEST(CoverRigidMotion, weight_works_on_the_shift_of_the_centre) {
  for (const CoverFunctions functions : kAllCoverFunctions) {
    const ElasticBodies bodies = rectangle(functions);
    EXPECT_NEAR(bodies.supports.load().dot(bodies.rigid.turned(0.5, {2, 2.5}, {7, 3})), -9.81 * 3 * 2 * kDensity, 1e-8);
    // x² over the rectangle as ½ vᵀ M v of the field (x, 0): ∫ x² = (27 - 1)/3.
    Eigen::VectorXd x = bodies.rigid.start();
    for (Eigen::Index i = 1; i < x.size(); i += 2) x(i) = 0;
    EXPECT_NEAR(x.dot(bodies.mass.times(x)), kDensity * 26 / 3, 1e-11 * kDensity * 26 / 3);
  }
}

}  // namespace keyblock::cover_rigid_motion_test
