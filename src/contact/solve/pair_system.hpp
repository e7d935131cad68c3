// What contact springs and inertia make of blocks in a step, solved by iterations: no matrix is made.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "contact/solve/block_numbers.hpp"

namespace keyblock {

/// H of one pair, force / length: the forces that rates make, fn = nn un and ft = tn un + tt ut. Slip is what tn is
/// for.
struct PairStiffness {
  double nn = 0;
  double tn = 0;
  double tt = 0;

  bool is_none() const { return nn == 0 && tn == 0 && tt == 0; }
  bool is_symmetric() const { return tn == 0; }
};

/// (A + Gᵀ H G) x = Gᵀ f with a block of A a block of the scene and two rows of G a pair. Conjugate gradients (Hestenes
/// & Stiefel 1952) or, where slip makes the matrix nonsymmetric, stabilised biconjugate ones (van der Vorst 1992),
/// preconditioned by the diagonal blocks of all of it.
class PairSystem {
 public:
  /// Rows 2i and 2i + 1 belong to pair i and the same two elements; none of them may be on covers.
  PairSystem(const ContactRows& rows, const BlockNumbers& blocks, const Table<ElementIndex, UnknownBlock>& flexibility);
  ~PairSystem();

  struct Result {
    Eigen::VectorXd rates;  ///< G x
    int products = 0;
    bool converged = false;
  };

  /// `h` has an entry a pair, `f` and `start` two, normal and tangential, as the rates of the result. From x = A⁻¹ Gᵀ
  /// `start`, until no block has a residual r with √(rᵀ A⁻¹ r) above the `goal`, or so many products were made.
  Result solve(const std::vector<PairStiffness>& h, const Eigen::VectorXd& f, const Eigen::VectorXd& start, double goal,
               int most_products) const;

  /// Iterations took longer than a factor does; whoever has a factor need not try them again.
  void give_up() const { gave_up_ = true; }
  bool gave_up() const { return gave_up_; }

  /// G A⁻¹ Gᵀ f.
  Eigen::VectorXd answer(const Eigen::VectorXd& f) const;

  /// Interface of the kernels, one for each size of block.
  class Kernel;

 private:
  std::unique_ptr<const Kernel> kernel_;
  mutable bool gave_up_ = false;
};

}  // namespace keyblock
