// What forces of contacts and constraints do to the rates along them, without the matrix of that ever being formed for
// blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "contact/rows/contact_row.hpp"
#include "contact/solve/block_numbers.hpp"
#include "contact/solve/pair_system.hpp"

namespace keyblock {

/// The entries of every row that are not 0, by the rows that it is coupled with, in their order.
class CoupledRows {
 public:
  struct Entry {
    Eigen::Index row = 0;
    double value = 0;
  };

  CoupledRows() = default;
  /// All rows at once. `mirrors`: of a symmetric matrix, of which the rows end with the diagonal.
  CoupledRows(const std::vector<std::vector<Entry>>& lower, bool mirrors);

  bool is_none() const { return first_.empty(); }
  std::span<const Entry> of(Eigen::Index i) const {
    const std::size_t first = first_[static_cast<std::size_t>(i)];
    return std::span(entries_).subspan(first, first_[static_cast<std::size_t>(i) + 1] - first);
  }
  /// Of the next row.
  void add(std::span<const Entry> entries);

 private:
  std::vector<std::size_t> first_;  ///< of each row in `entries_`, and their end
  std::vector<Entry> entries_;
};

/// G B Gᵀ by way of the shared unknowns alone, a solution a row. The unknowns of a body couple the rows that it has a
/// part in; of other rows B makes exact zeros, which are not kept.
class SharedCoupling {
 public:
  using Entry = CoupledRows::Entry;

  SharedCoupling() = default;
  SharedCoupling(const ContactRows& rows, const Flexibility& flexibility);

  bool is_none() const { return rows_.is_none(); }
  /// Of row i; none where nothing is shared.
  std::span<const Entry> entries(Eigen::Index i) const;
  double entry(Eigen::Index i, Eigen::Index j) const;
  /// Row i times forces.
  double rate(Eigen::Index i, const Eigen::VectorXd& forces) const;
  /// All rows times forces.
  Eigen::VectorXd times(const Eigen::VectorXd& forces) const;

 private:
  CoupledRows rows_;
};

/// W = G B Gᵀ + diag(added), with a row of G a force and a block of B an element: the flexibility of its unknowns,
/// symmetric but of rock whose flow is not normal to its surface, zero in rows and columns of unknowns that do not
/// answer. Those that do come first. Covers have one common part of B.
class ContactMatrix {
 public:
  ContactMatrix() = default;
  ContactMatrix(ContactRows rows, Flexibility flexibility);
  /// The same rows as others have; `store`: of BlockNumbers.
  ContactMatrix(std::shared_ptr<const ContactRows> rows, Flexibility flexibility,
                std::shared_ptr<FactorStore> store = {});

  Eigen::Index rows() const { return diagonal_.size(); }
  const Eigen::VectorXd& diagonal() const { return diagonal_; }
  const ContactRow& row(Eigen::Index i) const { return (*rows_)[static_cast<std::size_t>(i)]; }
  const Flexibility& flexibility() const { return flexibility_; }
  const SharedCoupling& shared() const { return shared_; }
  const Eigen::VectorXd& added() const { return added_; }
  /// Made when first asked for.
  const BlockNumbers& blocks() const;
  /// The entries of W by way of blocks and shared unknowns alike, without what was added. Made when first asked for.
  const CoupledRows& coupled() const;
  /// The same rows for products many times over; none for few blocks or pairs, or where shared unknowns couple rows.
  /// Made when first asked for.
  const PairSystem* pairs() const;

  /// The compliance of a spring, 1/p.
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

/// The diagonal of G B Gᵀ alone, with what shared unknowns couple made already.
Eigen::VectorXd diagonal_of(const ContactRows& rows, const Flexibility& flexibility, const SharedCoupling& shared);

/// A row of G times B, for entries of W where a few are wanted: entry (i, j) is row i times row j, without what was
/// added.
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
