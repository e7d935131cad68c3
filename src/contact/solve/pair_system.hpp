// Solves blocks with contact springs and inertia by iterations, without a matrix.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "contact/solve/block_numbers.hpp"

namespace keyblock {

/// H of one pair, force / length: forces by rates, fn = nn un and ft = tn un + tt ut. Slip makes tn nonzero.
struct PairStiffness {
  double nn = 0;
  double tn = 0;
  double tt = 0;

  bool is_none() const { return nn == 0 && tn == 0 && tt == 0; }
  bool is_symmetric() const { return tn == 0; }
};

/// System (A + Gᵀ H G) x = Gᵀ f, with one block of A per block of the scene and two rows of G per pair. It is solved by
/// conjugate gradients (Hestenes & Stiefel 1952). If slip makes it unsymmetric, stabilised biconjugate gradients serve
/// (van der Vorst 1992). The diagonal blocks of the whole matrix are the preconditioner.
class PairSystem {
 public:
  /// Takes rows 2i and 2i + 1 for pair i, both of the same two elements, which must not be NMM elements.
  PairSystem(const ContactRows& rows, const BlockNumbers& blocks, const Table<ElementIndex, UnknownBlock>& flexibility);
  ~PairSystem();

  struct Result {
    Eigen::VectorXd rates;  ///< G x
    int products = 0;
    bool converged = false;
  };

  /// Solves from x = A⁻¹ Gᵀ `start`. `h` has one entry per pair; `f`, `start` and the resulting rates have two, normal
  /// and tangential. It ends if no block has a residual r with √(rᵀ A⁻¹ r) above `goal`, or after `most_products`.
  Result solve(const std::vector<PairStiffness>& h, const Eigen::VectorXd& f, const Eigen::VectorXd& start, double goal,
               int most_products) const;

  /// Marks iterations as slower than a factorisation, so that callers with a factorisation need not try them again.
  void give_up() const { gave_up_ = true; }
  bool gave_up() const { return gave_up_; }

  /// Returns G A⁻¹ Gᵀ f.
  Eigen::VectorXd answer(const Eigen::VectorXd& f) const;

  /// Interface of the kernels, one per block size.
  class Kernel;

 private:
  std::unique_ptr<const Kernel> kernel_;
  mutable bool gave_up_ = false;
};

}  // namespace keyblock
