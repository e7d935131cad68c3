// The linear system of contact forces when it is decided which are open, stick or slip.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <memory>
#include <optional>

#include "contact/solve/frictional_problem.hpp"

namespace keyblock {

class CoupledForces;
class ForcesOfBlocks;

/// Which forces of an active set are unknown. Open pairs have their least normal force, slipping ones λt = ± (cohesion
/// + μ λn): what is left are one unknown a slipping pair and two a sticking one, with yn = 0 and, sticking, yt = 0.
struct ActiveSet {
  struct Column {
    Eigen::Index unknown = -1;  ///< of the force; none if it is given
    double factor = 0;          ///< force = factor × unknown + given
    double given = 0;
    double coupled = 0;  ///< of a tangential force: share of the unknown of its normal force that comes on top
  };
  std::vector<Column> columns;     ///< of each force
  std::vector<Eigen::Index> rows;  ///< force whose y is zero, of each unknown
  bool slips = false;

  ActiveSet() = default;
  ActiveSet(const std::vector<ForceLaw>& laws, const std::vector<Grip>& grips);
  /// The forces under these unknowns; `share` 0 leaves out what is given.
  Eigen::VectorXd forces(const Eigen::VectorXd& unknowns, double share) const;
  /// The entries of the rows kept.
  Eigen::VectorXd kept(const Eigen::VectorXd& all) const;
};

/// The slip makes the matrix nonsymmetric. It is factorised once and serves any right side: dense for a few forces,
/// sparse in the forces where covers couple them, else in the blocks that they act on; iterations take the place of the
/// last where inertia rules.
class ActiveForces {
 public:
  /// `added` stands on the diagonal of W beside its own entries; where an unknown force has neither, few forces can be
  /// solved only.
  ActiveForces(const FrictionalProblem& problem, const std::vector<Grip>& grips, const Eigen::VectorXd& added);
  /// Takes a set that its caller made, and solves (R W F + D) u = f, with D the springs and `added` of each unknown.
  ActiveForces(const FrictionalProblem& problem, ActiveSet set, const Eigen::VectorXd& added);
  ActiveForces(const ActiveForces&) = delete;  // its parts refer to each other
  ~ActiveForces();

  /// Whether solutions are as good as they were asked to be, and no better.
  bool iterates() const { return iterates_; }

  /// False where no factor was found: the active set leaves forces open.
  bool is_regular() const;

  /// The forces of all pairs for y = (W + added) λ + b; nothing where iterations fail and no factor is found either.
  /// Iterations begin at `near`, forces that may be near, and end where y, judged as a force, is at most `goal`;
  /// factors need neither.
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
  Eigen::VectorXd from_given_;  ///< y of the given forces, in the rows kept
  Eigen::PartialPivLU<Eigen::MatrixXd> dense_;
  std::unique_ptr<CoupledForces> coupled_;
  std::unique_ptr<ForcesOfBlocks> sparse_;
  bool iterates_ = false;
};

/// Serves while W, the laws and what is judged stay, at the same address.
struct KeptSystem {
  std::unique_ptr<ActiveForces> system;
  std::vector<Grip> grips;
  Eigen::VectorXd weights;  ///< of the proximal term
};

}  // namespace keyblock
