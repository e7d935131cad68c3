// Numbering of the unknown forces, assembly, and one of two factorisations by size.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/active_forces.hpp"

namespace keyblock {
namespace {

// Up to this many unknowns a dense factor beats the sparse one's bookkeeping.
constexpr std::size_t kMostDense = 48;

}  // namespace

ActiveForces::ActiveForces(const FrictionalProblem& problem, const std::vector<Grip>& grips,
                           const Eigen::VectorXd& added)
    : problem_(problem) {
  number(grips);
  assemble(added);
}

void ActiveForces::number(const std::vector<Grip>& grips) {
  for (std::size_t i = 0; i < grips.size(); ++i) {
    const ForceLaw& law = problem_.laws[i];
    const auto n = static_cast<Eigen::Index>(2 * i);
    const auto unknown = static_cast<Eigen::Index>(rows_.size());
    const auto add_unknown = [&](Eigen::Index force) {
      columns_.push_back({static_cast<Eigen::Index>(rows_.size()), 1, 0});
      rows_.push_back(force);
    };
    if (is_open(grips[i]))
      columns_.push_back({-1, 0, law.least});
    else
      add_unknown(n);
    if (grips[i] == Grip::open) {
      columns_.push_back({});
    } else if (grips[i] == Grip::stick || grips[i] == Grip::open_stick) {
      add_unknown(n + 1);
    } else {
      const double sign = grips[i] == Grip::slip_forward ? 1 : -1;
      columns_.push_back({unknown, sign * law.friction, sign * law.cohesion});
    }
  }
}

void ActiveForces::assemble(const Eigen::VectorXd& added) {
  const auto size = static_cast<Eigen::Index>(rows_.size());
  std::vector<Eigen::Triplet<double>> entries;
  from_given_ = Eigen::VectorXd::Zero(size);
  const auto add = [&](Eigen::Index row, Eigen::Index force, double w) {
    const Column& column = columns_[static_cast<std::size_t>(force)];
    if (column.unknown >= 0) entries.emplace_back(row, column.unknown, w * column.factor);
    from_given_[row] += w * column.given;
  };
  for (Eigen::Index row = 0; row < size; ++row) {
    const Eigen::Index force = rows_[static_cast<std::size_t>(row)];
    for (ContactMatrix::InnerIterator w(problem_.w, force); w; ++w) add(row, w.col(), w.value());
    add(row, force, added[force]);
  }
  if (rows_.size() <= kMostDense) {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size);
    for (const auto& entry : entries) a(entry.row(), entry.col()) += entry.value();
    if (size > 0) dense_.compute(a);
    return;
  }
  Eigen::SparseMatrix<double> a(size, size);
  a.setFromTriplets(entries.begin(), entries.end());
  sparse_ = std::make_unique<Eigen::SparseLU<Eigen::SparseMatrix<double>>>(a);
}

Eigen::VectorXd ActiveForces::solve(const Eigen::VectorXd& b) const {
  Eigen::VectorXd right = -from_given_;
  for (Eigen::Index row = 0; row < right.size(); ++row) right[row] -= b[rows_[static_cast<std::size_t>(row)]];
  Eigen::VectorXd unknowns = right;
  if (right.size() > 0)
    unknowns = sparse_ ? Eigen::VectorXd(sparse_->solve(right)) : Eigen::VectorXd(dense_.solve(right));
  Eigen::VectorXd forces(static_cast<Eigen::Index>(columns_.size()));
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Column& column = columns_[i];
    forces[static_cast<Eigen::Index>(i)] =
        column.given + (column.unknown < 0 ? 0 : column.factor * unknowns[column.unknown]);
  }
  return forces;
}

}  // namespace keyblock
