// A step of bodies on covers without contact, by Newton's method.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/bodies/cover_equations.hpp"

namespace keyblock {

struct ElasticStep {
  CoverMotion end;
  int iterations = 0;
  double residual = 0;  ///< over the largest of the forces
  /// To 1e-13 of the forces, or until round-off lets the correction fall no further.
  bool is_solved = false;
};

/// From `start` under `load` (CoverEquations::begin). Where is_solved is false, `end` is what 30 rounds left: a shorter
/// step is the remedy. Throws NotPositiveDefinite.
ElasticStep cover_step(CoverEquations& equations, const CoverMotion& start, const Eigen::VectorXd& load,
                       const StepRule& rule, double dt);

/// Where all is undeformed and at rest.
CoverMotion rest(const ElasticBodies& bodies);

/// M⁻¹ (load - elastic - constant - damping force): what `a` of a start is, for rules that carry accelerations.
Eigen::VectorXd acceleration_at(const ElasticBodies& bodies, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                                const Eigen::VectorXd& load);

/// The static equilibrium of elastic bodies under `load`, by Newton's method from q.
struct CoverEquilibrium {
  Eigen::VectorXd q;
  int iterations = 0;
  double residual = 0;
  bool is_solved = false;
};
CoverEquilibrium cover_equilibrium(const ElasticBodies& bodies, const Eigen::VectorXd& q, const Eigen::VectorXd& load);

}  // namespace keyblock
