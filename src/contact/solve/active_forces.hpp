// Solves the linear system of contact forces for given states of open, sticking and sliding contacts. Theory:
// docs/theory/05-frictional-contact.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <memory>
#include <optional>

#include "contact/solve/frictional_problem.hpp"

namespace keyblock {

class CoupledForces;
class ForcesOfBlocks;

/// Unknown forces of an active set. Open pairs have their least normal force, sliding ones λt = ± (cohesion + μ λn).
/// This leaves one unknown per sliding pair and two per sticking one, with yn = 0 and, if sticking, yt = 0.
struct ActiveSet {
  struct Column {
    Eigen::Index unknown = -1;  ///< of the force; -1 if it is given
    double factor = 0;          ///< force = factor × unknown + given
    double given = 0;
    double coupled = 0;  ///< tangential force: additional factor of the unknown of its normal force
  };
  std::vector<Column> columns;     ///< per force
  std::vector<Eigen::Index> rows;  ///< per unknown, the force whose y is zero
  bool slips = false;

  ActiveSet() = default;
  ActiveSet(const std::vector<ForceLaw>& laws, const std::vector<Grip>& grips);
  /// Returns the forces for these unknowns; `share` 0 leaves out the given part.
  Eigen::VectorXd forces(const Eigen::VectorXd& unknowns, double share) const;
  /// Returns the entries of the kept rows.
  Eigen::VectorXd kept(const Eigen::VectorXd& all) const;
};

/// Solves for the forces of an active set. Slip makes the matrix unsymmetric. One factorisation serves any right-hand
/// side. It is dense for a few forces, sparse in the forces if covers couple them, else in the blocks on which they
/// act. Iterations replace the last if inertia dominates.
class ActiveForces {
 public:
  /// Adds `added` to the diagonal of W. If an unknown force has no entry there from either, only few forces can be
  /// solved.
  ActiveForces(const FrictionalProblem& problem, const std::vector<Grip>& grips, const Eigen::VectorXd& added);
  /// Takes a given set and solves (R W F + D) u = f, with D the springs and `added` of each unknown.
  ActiveForces(const FrictionalProblem& problem, ActiveSet set, const Eigen::VectorXd& added);
  ActiveForces(const ActiveForces&) = delete;  // its parts refer to each other
  ~ActiveForces();

  /// Returns true if solutions are only as accurate as requested.
  bool iterates() const { return iterates_; }

  /// Returns false if the factorisation failed: the active set leaves forces undetermined.
  bool is_regular() const;

  /// Returns the forces of all pairs for y = (W + added) λ + b; empty if both iterations and factorisation fail.
  /// Iterations begin at `near`, approximate forces, and end if y, judged as a force, is at most `goal`. Factorisations
  /// need neither.
  std::optional<Eigen::VectorXd> solve(const Eigen::VectorXd& b, const Eigen::VectorXd& near, double goal);

 private:
  void factorise_dense();
  void factorise_coupled();
  void factorise_sparse();
  Eigen::VectorXd by_factor(const Eigen::VectorXd& right) const;
  bool is_inertia_great() const;
  std::optional<Eigen::VectorXd> by_iterations(const Eigen::VectorXd& right, const Eigen::VectorXd& near,
                                               double goal) const;

  const FrictionalProblem& problem_;
  ActiveSet set_;
  Eigen::VectorXd added_;
  Eigen::VectorXd from_given_;  ///< y of the given forces, in the kept rows
  Eigen::PartialPivLU<Eigen::MatrixXd> dense_;
  std::unique_ptr<CoupledForces> coupled_;
  std::unique_ptr<ForcesOfBlocks> sparse_;
  bool iterates_ = false;
};

/// System that stays valid while W, the laws and the judging compliance stay the same, at the same address.
struct KeptSystem {
  std::unique_ptr<ActiveForces> system;
  std::vector<Grip> grips;
  Eigen::VectorXd weights;  ///< of the proximal term
};

}  // namespace keyblock
