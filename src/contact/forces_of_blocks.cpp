// Outer products of the rows of each pair, over what is added to their diagonal.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/forces_of_blocks.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cstddef>

namespace keyblock {
namespace {

// Refinement ends where the residual over the right side is round-off, or no longer falls by the second figure.
constexpr double kRoundOff = 1e-14;
constexpr double kFalls = 0.1;
constexpr int kMostRefinements = 4;

using Row = ContactRow::Row;

// Leading unknowns that answer at all.
int answering(const UnknownBlock& flexibility) {
  int count = 0;
  while (count < flexibility.rows() && flexibility(count, count) > 0) ++count;
  return count;
}

UnknownBlock inverse_of(const UnknownBlock& flexibility, int size) {
  const UnknownBlock part = flexibility.topLeftCorner(size, size);
  return part.llt().solve(UnknownBlock::Identity(size, size));
}

}  // namespace

ForcesOfBlocks::ForcesOfBlocks(const ContactMatrix& w, const ActiveSet& set, const Eigen::VectorXd& added)
    : w_(w), set_(set), added_(added), compliance_(set.kept(w.added() + added)) {
  if (!(compliance_.minCoeff() > 0)) return;
  number();
  assemble();
  is_regular_ = factor_->factorise(!set.slips);
}

void ForcesOfBlocks::number() {
  int row = 0;
  for (const UnknownBlock& flexibility : w_.flexibility().blocks) {
    const int size = answering(flexibility);
    blocks_.push_back(size > 0 ? static_cast<int>(sizes_.size()) : -1);
    if (size == 0) continue;
    sizes_.push_back(size);
    first_rows_.push_back(row);
    row += size;
  }
  first_rows_.push_back(row);
  BlockPattern::Pairs coupled;
  for (Eigen::Index i = 0; i < w_.rows(); i += 2) {
    const int a = blocks_[w_.row(i).vertex_element];
    const int b = blocks_[w_.row(i).edge_element];
    if (a >= 0 && b >= 0 && a != b) coupled.emplace_back(std::min(a, b), std::max(a, b));
  }
  const auto count = static_cast<int>(sizes_.size());
  factor_ = std::make_unique<BlockFactor>(std::make_shared<BlockPattern>(count, coupled), sizes_);
}

int ForcesOfBlocks::size_of(int block) const {
  return block < 0 ? 0 : sizes_[static_cast<std::size_t>(block)];
}

void ForcesOfBlocks::assemble() {
  for (ElementIndex e : indices(w_.flexibility().blocks))
    if (blocks_[e] >= 0)
      factor_->add(blocks_[e], blocks_[e], inverse_of(w_.flexibility().blocks[e], size_of(blocks_[e])));
  for (std::size_t first = 0; first < set_.rows.size();) {
    const Eigen::Index pair = set_.rows[first] - set_.rows[first] % 2;
    const bool is_two = first + 1 < set_.rows.size() && set_.rows[first + 1] == pair + 1;
    add_pair(pair, first, is_two ? 2 : 1);
    first += is_two ? 2 : 1;
  }
}

// Both forces of a pair act between the same two elements: four blocks in all, each the sum over its unknowns.
void ForcesOfBlocks::add_pair(Eigen::Index pair, std::size_t first_unknown, int count) {
  const ContactRow& any = w_.row(pair);
  const int blocks[2] = {blocks_[any.vertex_element], blocks_[any.edge_element]};
  BlockFactor::Block sums[2][2];
  for (int i : {0, 1})
    for (int j : {0, 1}) sums[i][j].setZero(size_of(blocks[i]), size_of(blocks[j]));
  for (int k = 0; k < count; ++k) {
    const std::size_t unknown = first_unknown + static_cast<std::size_t>(k);
    const ContactRow& row = w_.row(set_.rows[unknown]);
    Row of_vertex = Row::Zero(any.of_vertex.size());
    Row of_edge = Row::Zero(any.of_edge.size());
    for (const Eigen::Index force : {pair, pair + 1}) {
      const ActiveSet::Column& column = set_.columns[static_cast<std::size_t>(force)];
      if (column.unknown != static_cast<Eigen::Index>(unknown)) continue;
      of_vertex += column.factor * w_.row(force).of_vertex;
      of_edge += column.factor * w_.row(force).of_edge;
    }
    const double stiffness = 1 / compliance_[static_cast<Eigen::Index>(unknown)];
    const Row* columns[2] = {&of_vertex, &of_edge};
    const Row* across[2] = {&row.of_vertex, &row.of_edge};
    for (int i : {0, 1})
      for (int j : {0, 1})
        sums[i][j].noalias() +=
            (stiffness * columns[i]->head(size_of(blocks[i]))).transpose() * across[j]->head(size_of(blocks[j]));
  }
  for (int i : {0, 1})
    for (int j : {0, 1})
      if (blocks[i] >= 0 && blocks[j] >= 0) factor_->add(blocks[i], blocks[j], sums[i][j]);
}

// Gᵀ f on the unknowns that answer.
Eigen::VectorXd ForcesOfBlocks::on_blocks(const Eigen::VectorXd& forces) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(first_rows_.back());
  const auto add = [&](ElementIndex e, const Row& row, double force) {
    const int block = blocks_[e];
    if (block >= 0)
      sum.segment(first_rows_[static_cast<std::size_t>(block)], size_of(block)) +=
          force * row.head(size_of(block)).transpose();
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
    const int block = blocks_[e];
    if (block < 0) return 0.0;
    return row.head(size_of(block)).dot(x.segment(first_rows_[static_cast<std::size_t>(block)], size_of(block)));
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
    return Eigen::VectorXd(right - set_.kept(w_ * forces + added_.cwiseProduct(forces)));
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
