// Computes the slowest vibration of a fixed NMM body, as a coordinate with one frequency only.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "step/bodies/elastic_bodies.hpp"
#include "step/bodies/linear_static.hpp"
#include "system/part_factors.hpp"

namespace keyblock {

struct CoverMode {
  Eigen::VectorXd mass_times_shape;  ///< M φ with φᵀ M φ = 1: φᵀ M q is the mode's coordinate
  double omega = 0;                  ///< rad / time

  double coordinate(const Eigen::VectorXd& q) const { return mass_times_shape.dot(q); }
  double frequency() const { return omega / (2 * std::numbers::pi); }
};

/// Inverse iteration on K φ = ω² M φ in the initial state.
inline CoverMode slowest_mode(const ElasticBodies& bodies) {
  SparseSystem stiffness = bodies.mass;
  stiffness.clear();
  bodies.elasticity.add_static_tangent(Eigen::VectorXd::Zero(bodies.unknown_count()), 1, stiffness);
  stiffness.add_scaled(1, bodies.ghost);
  stiffness.add_scaled(1, bodies.supports);
  PartFactors factors(stiffness, bodies.rigid.functions(), definiteness_of(bodies.continuum.functions));
  factors.factorise(stiffness);
  Eigen::VectorXd shape = factors.solve(bodies.supports.load());
  for (int round = 0; round < 30; ++round) {
    shape = factors.solve(bodies.mass.times(shape));
    shape /= std::sqrt(shape.dot(bodies.mass.times(shape)));
  }
  return {bodies.mass.times(shape), std::sqrt(shape.dot(stiffness.times(shape)))};
}

}  // namespace keyblock
