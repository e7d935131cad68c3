// Solves for the forces of an active set through the unknowns of the blocks, in a sparse system of that size.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/solve/active_forces.hpp"
#include "system/block_factor.hpp"

namespace keyblock {

/// Let W = G B Gᵀ (contact_matrix.hpp) and (R W F + R D F) u = f. R are the kept rows, F the columns. D > 0 is the
/// added diagonal (compliance and proximal weight, length / force). The system is equivalent to
///     (A + Gᵀ F D⁻¹ R G) x = Gᵀ F D⁻¹ f,   u = D⁻¹ (f − R G x),   A = B⁻¹,
/// because D is alone in the row of each unknown. This matrix is that of penalty springs of stiffness 1/D between
/// blocks (Shi 1988), including slip. The solution is refined on the equations of the forces.
class ForcesOfBlocks {
 public:
  ForcesOfBlocks(const ContactMatrix& w, const ActiveSet& set, const Eigen::VectorXd& added);
  ForcesOfBlocks(const ForcesOfBlocks&) = delete;  // its factorisation goes back to the matrix
  ForcesOfBlocks& operator=(const ForcesOfBlocks&) = delete;
  ~ForcesOfBlocks() {
    if (factor_) blocks_.give_back(std::move(factor_));
  }

  bool is_regular() const { return is_regular_; }
  /// Returns u for one f, one entry per unknown.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  bool factorise(MatrixShape shape);
  void add_pair(Eigen::Index pair, std::size_t first_unknown, int count, MatrixShape shape);
  /// Serves blocks that all have N unknowns, or any number.
  template <int N>
  void add_pair_of(Eigen::Index pair, std::size_t first_unknown, int count, MatrixShape shape);
  Eigen::VectorXd on_blocks(const Eigen::VectorXd& forces) const;
  double rate(Eigen::Index row, const Eigen::VectorXd& x) const;
  Eigen::VectorXd once(const Eigen::VectorXd& right) const;

  const ContactMatrix& w_;
  const ActiveSet& set_;
  Eigen::VectorXd added_;
  Eigen::VectorXd compliance_;  ///< D per unknown
  const BlockNumbers& blocks_;
  std::unique_ptr<BlockFactor> factor_;
  bool is_regular_ = false;
};

}  // namespace keyblock
