// Sets up the equations of one step of NMM bodies, linearised about an estimate, for the contact solver. Counterpart
// for a DDA block: step_equations. Theory: docs/theory/02-equations-of-motion.md and
// docs/theory/03-time-integration.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "step/bodies/elastic_bodies.hpp"
#include "step/bodies/integrator.hpp"
#include "system/part_factors.hpp"

namespace keyblock {

/// Unknowns, velocities, accelerations, and memories of the points of elastoplastic rock.
struct CoverMotion {
  Eigen::VectorXd q;
  Eigen::VectorXd v;
  Eigen::VectorXd a;
  YieldStates points = {};
};

/// Residual of a step:
///   r(Δq) = M inertia + a M damping + f(q0, q0 + Δq; θ + b/dt) + ghost_force(q0, q0 + Δq; θ) + H (q0 + θ Δq) - F.
/// The sums and θ = rule.stiffness follow StepRule; a, b are those of CoverDamping. b takes the mean strain rate of the
/// step under any rule. With contact forces λ,
///   Δq = free_increment + A⁻¹ Jᵀ λ,   A = ∂r/∂Δq.
/// A is symmetrised (CoverElasticity::add_tangent), except for bodies whose law has an unsymmetric tangent. Iterate
/// with linearise(Δq) until Δq stays: the residual is exact, A need not be. end(Δq) is the end of the step. One object
/// serves all steps of a run and keeps the elimination order. The bodies must outlive it.
class CoverEquations {
 public:
  explicit CoverEquations(const ElasticBodies& bodies);

  const ElasticBodies& bodies() const { return bodies_; }

  /// Begins a step. `load` F: all forces on the unknowns that r does not name, and ElasticBodies::supports.load() if
  /// its loads act.
  void begin(const CoverMotion& start, const Eigen::VectorXd& load, const StepRule& rule, double dt);

  /// Computes residual and factorisation at Δq = `increment`. Throws NotPositiveDefinite, SingularMatrix.
  void linearise(const Eigen::VectorXd& increment);
  /// Computes the residual alone; the factorisation stays that of the last linearise, even of an earlier step.
  void evaluate(const Eigen::VectorXd& increment);
  bool is_symmetric() const { return factors_.are_symmetric(); }
  /// Returns true if a factorisation exists and its rule and dt gave the same weights.
  bool has_factor() const;

  const Eigen::VectorXd& residual() const { return residual_; }
  /// Returns `increment` - A⁻¹ r.
  Eigen::VectorXd free_increment() const { return increment_ - factors_.solve(residual_); }
  /// Returns A⁻¹ `right` for all unknowns.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const { return factors_.solve(right); }
  /// Returns A⁻¹ `right` of one body for many right-hand sides; rows ordered as CoverRigidMotion::functions.
  Eigen::MatrixXd solve(int body, const Eigen::MatrixXd& right) const { return factors_.solve(body, right); }

  /// Returns the known part of the velocity and acceleration at the end; the rule adds its multiple of Δq.
  const Eigen::VectorXd& known_velocity() const { return known_velocity_; }
  const Eigen::VectorXd& known_acceleration() const { return known_acceleration_; }
  /// Returns the motion at the end. If functions depend on each other, velocities without motion are removed: their
  /// round-off would grow from step to step.
  CoverMotion end(const Eigen::VectorXd& increment) const;

 private:
  const ElasticBodies& bodies_;
  SparseSystem tangent_;
  std::optional<WholeSystem> whole_;  // of all bodies, if the matrix of one is not symmetric
  PartFactors factors_;
  struct Weights {
    double force = 1;        // θ
    double strain_rate = 0;  // 1/dt, of b; 0 if the rule ignores it
    double mass = 0;         // of M Δq
    double damping = 0;      // of a M Δq
    bool operator==(const Weights&) const = default;
  };
  StepRule rule_;
  Weights weights_;
  Weights factor_weights_;
  bool is_factorised_ = false;
  CoverYield::Way way_to(const Eigen::VectorXd& end) const {
    return {start_, points_, end, weights_.force, of_strain_rate_};
  }

  Eigen::VectorXd start_;  // q0
  YieldStates points_;
  Eigen::VectorXd load_;
  Eigen::VectorXd known_velocity_;
  Eigen::VectorXd known_acceleration_;
  Eigen::VectorXd known_inertia_;
  Eigen::VectorXd known_damping_;
  std::vector<double> of_strain_rate_;  // b/dt of each element; empty if all are 0
  Eigen::VectorXd increment_;
  Eigen::VectorXd residual_;
};

}  // namespace keyblock
