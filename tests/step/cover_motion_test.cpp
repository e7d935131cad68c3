// Bodies on covers that fly, spin, swing and bend far, against closed forms: benchmarks nmm-02 and nmm-06, the elastica.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/cover_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/polygon.hpp"
#include "terms/cover_inertia.hpp"
#include "tests/support/continuum_scenes.hpp"

namespace keyblock {
namespace {

StepRule weighted(double force_weight, double dt) {
  StandardChoices choices;
  choices.force_weight = force_weight;
  return step_rule(choices, dt);
}

/// A unit square of modulus 1e6 and density 1000 (waves 33 m/s) on a mesh turned by 10°.
Continuum square(CoverFunctions functions, double h) {
  Continuum continuum;
  continuum.manifold = cut_body({rectangle_corners({0, 0}, {1, 1})}, MeshSetting{h});
  continuum.materials = {elastic_material(1e6, 0.25)};
  continuum.materials[0].density = 1000;
  continuum.functions = functions;
  return continuum;
}

CoverMotion moving(const CoverBodies& bodies, const Eigen::Vector3d& rates) {
  CoverMotion motion = rest(bodies);
  const Point centre = bodies.rigid.motions(motion.q, motion.v)[0].centre;
  motion.v = bodies.rigid.modes(0, motion.q, centre) * rates;
  return motion;
}

double area_of(const CoverBodies& bodies, const Eigen::VectorXd& q) {
  double sum = 0;
  for (int e = 0; e < bodies.basis().element_count(); ++e) {
    const ManifoldElement& element = bodies.continuum.manifold.elements[static_cast<std::size_t>(e)];
    std::vector<Point> corners;
    for (const ElementCorner& corner : bodies.continuum.manifold.loop(element.outer))
      corners.push_back(bodies.elasticity.position(q, e, corner.position));
    sum += area(corners);
  }
  return sum;
}

}  // namespace

TEST(CoverMotion, free_fall_is_exact) {
  for (const CoverFunctions functions : kAllCoverFunctions) {
    const CoverBodies bodies(square(functions, 0.6));
    CoverEquations equations(bodies);
    CoverMotion motion = moving(bodies, {2, 3, 0});
    const Eigen::VectorXd weight = cover_weight(bodies.continuum, bodies.basis(), {0, -10});
    for (int step = 0; step < 100; ++step) motion = cover_step(equations, motion, weight, weighted(1, 0.01), 0.01).end;
    const Point at = bodies.elasticity.position(motion.q, 0, {0.5, 0.5});
    EXPECT_NEAR(at.x, 2.5, 1e-12) << name_of(functions);
    EXPECT_NEAR(at.y, 0.5 + 3 - 5, 1e-12);
    EXPECT_LT(bodies.energy(motion.q), 1e-15 * 1e6);
    EXPECT_NEAR(area_of(bodies, motion.q), 1, 1e-12);
  }
}

}  // namespace keyblock
