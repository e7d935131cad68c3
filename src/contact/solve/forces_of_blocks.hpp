// The forces of an active set by way of the blocks that they act on: as many equations as unknowns of blocks, and
// sparse.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/solve/active_forces.hpp"
#include "system/block_factor.hpp"

namespace keyblock {

/// With W = G B Gᵀ (contact_matrix.hpp), (R W F + R D F) u = f, R the rows kept, F the columns and D > 0 what stands on
/// the diagonal besides (compliance and proximal weight, length / force), is
///     (A + Gᵀ F D⁻¹ R G) x = Gᵀ F D⁻¹ f,   u = D⁻¹ (f − R G x),   A = B⁻¹,
/// for D stands alone in the row of each unknown. It is what penalty springs of stiffness 1/D put between blocks (Shi
/// 1988), slip included, and is refined on the equations of the forces.
class ForcesOfBlocks {
 public:
  ForcesOfBlocks(const ContactMatrix& w, const ActiveSet& set, const Eigen::VectorXd& added);
  ForcesOfBlocks(const ForcesOfBlocks&) = delete;  // its factor goes back to the matrix
  ForcesOfBlocks& operator=(const ForcesOfBlocks&) = delete;
  ~ForcesOfBlocks() {
    if (factor_) blocks_.give_back(std::move(factor_));
  }

  bool is_regular() const { return is_regular_; }
  /// u for one f, an entry an unknown each.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  bool factorise(MatrixShape shape);
  void add_pair(Eigen::Index pair, std::size_t first_unknown, int count, MatrixShape shape);
  /// Of blocks that all have N unknowns, or any number.
  template <int N>
  void add_pair_of(Eigen::Index pair, std::size_t first_unknown, int count, MatrixShape shape);
  Eigen::VectorXd on_blocks(const Eigen::VectorXd& forces) const;
  double rate(Eigen::Index row, const Eigen::VectorXd& x) const;
  Eigen::VectorXd once(const Eigen::VectorXd& right) const;

  const ContactMatrix& w_;
  const ActiveSet& set_;
  Eigen::VectorXd added_;
  Eigen::VectorXd compliance_;  ///< D, of each unknown
  const BlockNumbers& blocks_;
  std::unique_ptr<BlockFactor> factor_;
  bool is_regular_ = false;
};

}  // namespace keyblock
