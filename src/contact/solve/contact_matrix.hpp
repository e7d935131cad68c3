// Holds the response matrix of contact and constraint forces as an operator, without forming it for blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "contact/rows/contact_row.hpp"
#include "contact/solve/block_numbers.hpp"
#include "contact/solve/pair_system.hpp"

namespace keyblock {

/// Nonzero entries of every row, ordered by the coupled rows.
class CoupledRows {
 public:
  struct Entry {
    Eigen::Index row = 0;
    double value = 0;
  };

  CoupledRows() = default;
  /// Takes all rows at once. `mirrors`: the matrix is symmetric and its rows end with the diagonal.
  CoupledRows(const std::vector<std::vector<Entry>>& lower, bool mirrors);

  bool is_none() const { return first_.empty(); }
  std::span<const Entry> of(Eigen::Index i) const {
    const std::size_t first = first_[static_cast<std::size_t>(i)];
    return std::span(entries_).subspan(first, first_[static_cast<std::size_t>(i) + 1] - first);
  }
  /// Appends the next row.
  void add(std::span<const Entry> entries);

 private:
  std::vector<std::size_t> first_;  ///< start of each row in `entries_`, and the end
  std::vector<Entry> entries_;
};

/// Part of G B Gᵀ by the shared unknowns alone, one solve per row. A body's unknowns couple the rows of its contacts.
/// For other rows B gives exact zeros, which are not kept.
class SharedCoupling {
 public:
  using Entry = CoupledRows::Entry;

  SharedCoupling() = default;
  SharedCoupling(const ContactRows& rows, const Flexibility& flexibility);

  bool is_none() const { return rows_.is_none(); }
  /// Returns the entries of row i; empty without shared unknowns.
  std::span<const Entry> entries(Eigen::Index i) const;
  double entry(Eigen::Index i, Eigen::Index j) const;
  /// Returns row i times forces.
  double rate(Eigen::Index i, const Eigen::VectorXd& forces) const;
  /// Returns all rows times forces.
  Eigen::VectorXd times(const Eigen::VectorXd& forces) const;

 private:
  CoupledRows rows_;
};

/// W = G B Gᵀ + diag(added), with one row of G per force. B has one block per element, the flexibility of its unknowns.
/// Blocks are symmetric except for rock with non-associated flow. They are zero in rows and columns of unknowns that do
/// not respond, which come last. NMM bodies share one common part of B.
class ContactMatrix {
 public:
  ContactMatrix() = default;
  ContactMatrix(ContactRows rows, Flexibility flexibility);
  /// Shares rows with other matrices; `store`: as in BlockNumbers.
  ContactMatrix(std::shared_ptr<const ContactRows> rows, Flexibility flexibility,
                std::shared_ptr<FactorStore> store = {});

  Eigen::Index rows() const { return diagonal_.size(); }
  const Eigen::VectorXd& diagonal() const { return diagonal_; }
  const ContactRow& row(Eigen::Index i) const { return (*rows_)[static_cast<std::size_t>(i)]; }
  const Flexibility& flexibility() const { return flexibility_; }
  const SharedCoupling& shared() const { return shared_; }
  const Eigen::VectorXd& added() const { return added_; }
  /// Returns the block numbers, made on first request.
  const BlockNumbers& blocks() const;
  /// Returns the entries of W by blocks and shared unknowns, without the added diagonal. Made on first request.
  const CoupledRows& coupled() const;
  /// Returns the rows in a form for many products; null for few blocks or pairs, or if shared unknowns couple rows.
  /// Made on first request.
  const PairSystem* pairs() const;

  /// Adds to the diagonal, for example the compliance 1/p of a spring.
  void add_to_diagonal(Eigen::Index row, double value);

  Eigen::VectorXd operator*(const Eigen::VectorXd& forces) const;

 private:
  std::shared_ptr<const ContactRows> rows_ = std::make_shared<ContactRows>();
  Flexibility flexibility_;
  SharedCoupling shared_;
  Eigen::VectorXd diagonal_;
  Eigen::VectorXd added_;
  std::shared_ptr<FactorStore> store_;
  mutable std::shared_ptr<const BlockNumbers> blocks_;
  mutable std::shared_ptr<const CoupledRows> coupled_;
  bool has_many_pairs_ = false;
  mutable std::shared_ptr<const PairSystem> pairs_;
};

/// Returns the diagonal of G B Gᵀ, given the coupling by shared unknowns.
Eigen::VectorXd diagonal_of(const ContactRows& rows, const Flexibility& flexibility, const SharedCoupling& shared);

/// Row of G times B, for single entries of W. Entry (i, j) is row i times row j, without the added diagonal.
class RowThrough {
 public:
  RowThrough(const ContactMatrix& w, Eigen::Index i);
  double times(Eigen::Index j) const;

 private:
  const ContactMatrix& w_;
  Eigen::Index i_;
  ContactRow through_;
};

}  // namespace keyblock
