// Assembles outer products of the rows of each pair, divided by their added diagonal.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solve/forces_of_blocks.hpp"

#include <algorithm>
#include <cstddef>

namespace keyblock {
namespace {

// Refinement ends if the residual over the right-hand side is round-off, or stays above kFalls times the last.
constexpr double kRoundOff = 1e-14;
constexpr double kFalls = 0.1;
constexpr int kMostRefinements = 4;

using Row = ContactRow::Row;

}  // namespace

ForcesOfBlocks::ForcesOfBlocks(const ContactMatrix& w, const ActiveSet& set, const Eigen::VectorXd& added)
    : w_(w), set_(set), added_(added), compliance_(set.kept(w.added() + added)), blocks_(w.blocks()) {
  if (!(compliance_.minCoeff() > 0)) return;
  const bool is_symmetric = !set.slips && w.flexibility().has_symmetric_blocks;
  // Round-off may make a pivot negative; the general factorisation then succeeds.
  is_regular_ = (is_symmetric && factorise(MatrixShape::symmetric)) || factorise(MatrixShape::general);
}

bool ForcesOfBlocks::factorise(MatrixShape shape) {
  if (factor_) blocks_.give_back(std::move(factor_));
  factor_ = blocks_.take_factor(shape);
  for (int block = 0; block < blocks_.count(); ++block) factor_->add(block, block, blocks_.stiffness(block));
  for (std::size_t first = 0; first < set_.rows.size();) {
    const Eigen::Index pair = set_.rows[first] - set_.rows[first] % 2;
    const bool is_two = first + 1 < set_.rows.size() && set_.rows[first + 1] == pair + 1;
    add_pair(pair, first, is_two ? 2 : 1, shape);
    first += is_two ? 2 : 1;
  }
  return factor_->factorise();
}

void ForcesOfBlocks::add_pair(Eigen::Index pair, std::size_t first_unknown, int count, MatrixShape shape) {
  const ContactRow& any = w_.row(pair);
  const auto is_whole = [&](ElementIndex e) { return blocks_.size(blocks_.of(e)) == kMostUnknowns; };
  if (is_whole(any.vertex_element) && is_whole(any.edge_element))
    add_pair_of<kMostUnknowns>(pair, first_unknown, count, shape);
  else
    add_pair_of<Eigen::Dynamic>(pair, first_unknown, count, shape);
}

// Both forces of a pair act between the same two elements: four blocks in all, each the sum over its unknowns.
template <int N>
void ForcesOfBlocks::add_pair_of(Eigen::Index pair, std::size_t first_unknown, int count, MatrixShape shape) {
  using Side = Eigen::Matrix<double, N, 1, Eigen::ColMajor, kMostUnknowns, 1>;
  using Sum = Eigen::Matrix<double, N, N, Eigen::ColMajor, kMostUnknowns, kMostUnknowns>;
  const ContactRow& any = w_.row(pair);
  const int blocks[2] = {blocks_.of(any.vertex_element), blocks_.of(any.edge_element)};
  const auto side = [&](Eigen::Index force, int i) {
    const Row& row = i == 0 ? w_.row(force).of_vertex : w_.row(force).of_edge;
    return Eigen::Map<const Side>(row.data(), blocks_.size(blocks[i]));
  };
  const auto is_wanted = [&](int i, int j) {
    return blocks[i] >= 0 && blocks[j] >= 0 && (i <= j || shape == MatrixShape::general);
  };
  Sum sums[2][2];
  for (int i : {0, 1})
    for (int j : {0, 1}) sums[i][j].setZero(blocks_.size(blocks[i]), blocks_.size(blocks[j]));
  for (int k = 0; k < count; ++k) {
    const std::size_t unknown = first_unknown + static_cast<std::size_t>(k);
    const double stiffness = 1 / compliance_[static_cast<Eigen::Index>(unknown)];
    for (int i : {0, 1}) {
      Side column = Side::Zero(blocks_.size(blocks[i]));
      for (const Eigen::Index force : {pair, pair + 1}) {
        const ActiveSet::Column& of = set_.columns[static_cast<std::size_t>(force)];
        if (of.unknown == static_cast<Eigen::Index>(unknown)) column += stiffness * of.factor * side(force, i);
        const ActiveSet::Column& normal = set_.columns[static_cast<std::size_t>(pair)];
        if (of.coupled != 0 && normal.unknown == static_cast<Eigen::Index>(unknown))
          column += stiffness * of.coupled * side(force, i);
      }
      for (int j : {0, 1})
        if (is_wanted(i, j)) sums[i][j].noalias() += column * side(set_.rows[unknown], j).transpose();
    }
  }
  for (int i : {0, 1})
    for (int j : {0, 1})
      if (is_wanted(i, j)) factor_->add(blocks[i], blocks[j], sums[i][j]);
}

// Returns Gᵀ f on the responding unknowns.
Eigen::VectorXd ForcesOfBlocks::on_blocks(const Eigen::VectorXd& forces) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(blocks_.row_count());
  const auto add = [&](ElementIndex e, const Row& row, double force) {
    const int block = blocks_.of(e);
    if (block < 0) return;
    if (blocks_.size(block) == kMostUnknowns)
      sum.segment<kMostUnknowns>(blocks_.first_row(block)) += force * Eigen::Map<const AllUnknowns>(row.data());
    else
      sum.segment(blocks_.first_row(block), blocks_.size(block)) += force * row.head(blocks_.size(block)).transpose();
  };
  for (Eigen::Index i = 0; i < forces.size(); ++i) {
    if (forces[i] == 0) continue;
    add(w_.row(i).vertex_element, w_.row(i).of_vertex, forces[i]);
    add(w_.row(i).edge_element, w_.row(i).of_edge, forces[i]);
  }
  return sum;
}

double ForcesOfBlocks::rate(Eigen::Index i, const Eigen::VectorXd& x) const {
  const auto of = [&](ElementIndex e, const Row& row) {
    const int block = blocks_.of(e);
    if (block < 0) return 0.0;
    if (blocks_.size(block) == kMostUnknowns)
      return Eigen::Map<const AllUnknowns>(row.data()).dot(x.segment<kMostUnknowns>(blocks_.first_row(block)));
    return row.head(blocks_.size(block)).dot(x.segment(blocks_.first_row(block), blocks_.size(block)));
  };
  return of(w_.row(i).vertex_element, w_.row(i).of_vertex) + of(w_.row(i).edge_element, w_.row(i).of_edge);
}

Eigen::VectorXd ForcesOfBlocks::once(const Eigen::VectorXd& right) const {
  Eigen::VectorXd x = on_blocks(set_.forces(right.cwiseQuotient(compliance_), 0));
  factor_->solve({x.data(), static_cast<std::size_t>(x.size())});
  Eigen::VectorXd unknowns = right;
  for (std::size_t u = 0; u < set_.rows.size(); ++u) unknowns[static_cast<Eigen::Index>(u)] -= rate(set_.rows[u], x);
  return unknowns.cwiseQuotient(compliance_);
}

Eigen::VectorXd ForcesOfBlocks::solve(const Eigen::VectorXd& right) const {
  const auto misfit = [&](const Eigen::VectorXd& unknowns) {
    const Eigen::VectorXd forces = set_.forces(unknowns, 0);
    return Eigen::VectorXd(right - set_.kept(w_ * forces - w_.added().cwiseProduct(forces)) -
                           compliance_.cwiseProduct(unknowns));
  };
  const double goal = kRoundOff * right.norm();
  Eigen::VectorXd best = once(right);
  Eigen::VectorXd left = misfit(best);
  for (int i = 0; i < kMostRefinements && left.norm() > goal; ++i) {
    const Eigen::VectorXd next = best + once(left);
    Eigen::VectorXd after = misfit(next);
    if (!(after.norm() < left.norm())) break;
    const bool falls = after.norm() < kFalls * left.norm();
    best = next;
    left = std::move(after);
    if (!falls) break;
  }
  return best;
}

}  // namespace keyblock
