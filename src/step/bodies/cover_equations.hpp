// The equations of one step of bodies on covers, linearised about an estimate: what a contact solver drives, as
// step_equations for a block.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "step/bodies/elastic_bodies.hpp"
#include "step/bodies/integrator.hpp"
#include "system/part_factors.hpp"

namespace keyblock {

/// Unknowns, their velocities and accelerations, and what points of yielding rock remember.
struct CoverMotion {
  Eigen::VectorXd q;
  Eigen::VectorXd v;
  Eigen::VectorXd a;
  YieldStates points = {};
};

/// r(Δq) = M inertia + a M damping + f(q0, q0 + Δq; θ + b/dt) + ghost_force(q0, q0 + Δq; θ) + H (q0 + θ Δq) - F,
/// the sums and θ = rule.stiffness as StepRule has them; a, b of CoverDamping, where b takes the mean rate of strain
/// over the step whatever the rule. In the step with contact
///     Δq = free_increment + A⁻¹ Jᵀ λ,   A = ∂r/∂Δq,
/// made symmetric (CoverElasticity::add_tangent) but for bodies whose law has a tangent that is not: those have the
/// exact one. Solved again from linearise(Δq) until Δq stays: the residual is exact, A need not be. The end of the step
/// is end(Δq). One object serves all steps of a run; the bodies must outlive it. The order of elimination is found
/// once.
class CoverEquations {
 public:
  explicit CoverEquations(const ElasticBodies& bodies);

  const ElasticBodies& bodies() const { return bodies_; }

  /// A new step. `load` F: all forces on the unknowns besides those above, ElasticBodies::supports.load() included
  /// where its loads act.
  void begin(const CoverMotion& start, const Eigen::VectorXd& load, const StepRule& rule, double dt);

  /// Residual and factor at Δq = `increment`. Throws NotPositiveDefinite, SingularMatrix.
  void linearise(const Eigen::VectorXd& increment);
  /// The residual alone: the factor stays that of the last linearise, of whatever step.
  void evaluate(const Eigen::VectorXd& increment);
  bool is_symmetric() const { return factors_.are_symmetric(); }
  /// Whether there is a factor that was made for a rule and a dt with the same weights.
  bool has_factor() const;

  const Eigen::VectorXd& residual() const { return residual_; }
  /// Norm of the largest of the forces that make up the residual.
  double force_scale() const { return force_scale_; }
  /// `increment` - A⁻¹ r.
  Eigen::VectorXd free_increment() const { return increment_ - factors_.solve(residual_); }
  /// A⁻¹ `right` of all unknowns.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const { return factors_.solve(right); }
  /// A⁻¹ `right` of one body, for many right sides; rows as CoverRigidMotion::functions.
  Eigen::MatrixXd solve(int body, const Eigen::MatrixXd& right) const { return factors_.solve(body, right); }

  /// Velocity and acceleration at the end: known part and the rule's share of Δq.
  const Eigen::VectorXd& known_velocity() const { return known_velocity_; }
  const Eigen::VectorXd& known_acceleration() const { return known_acceleration_; }
  /// Of functions that depend on each other, the velocities that move nothing are taken out: a step would carry their
  /// round-off on to the next, where it grows.
  CoverMotion end(const Eigen::VectorXd& increment) const;

 private:
  const ElasticBodies& bodies_;
  SparseSystem tangent_;
  std::optional<WholeSystem> whole_;  // of all bodies, where that of one is not symmetric
  PartFactors factors_;
  struct Weights {
    double force = 1;        // θ
    double strain_rate = 0;  // 1/dt, of b; 0 where the rule takes none
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
  std::vector<double> of_strain_rate_;  // b/dt of each element; empty where all are 0
  Eigen::VectorXd increment_;
  Eigen::VectorXd residual_;
  double force_scale_ = 0;
};

}  // namespace keyblock
