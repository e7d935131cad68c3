// What forces of contacts and ties do to the rates along them, without the matrix of that ever being formed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "contact/contact_row.hpp"

namespace keyblock {

/// W = G B Gᵀ + diag(added), with a row of G a force and a block of B an element: the flexibility of its unknowns, symmetric,
/// zero in rows and columns of unknowns that do not answer. Those that do come first.
class ContactMatrix {
 public:
  ContactMatrix() = default;
  ContactMatrix(ContactRows rows, Table<ElementIndex, UnknownBlock> flexibility);

  Eigen::Index rows() const { return diagonal_.size(); }
  const Eigen::VectorXd& diagonal() const { return diagonal_; }
  const ContactRow& row(Eigen::Index i) const { return rows_[static_cast<std::size_t>(i)]; }
  const Table<ElementIndex, UnknownBlock>& flexibility() const { return flexibility_; }
  const Eigen::VectorXd& added() const { return added_; }

  /// The compliance of a spring, 1/p.
  void add_to_diagonal(Eigen::Index row, double value);

  Eigen::VectorXd operator*(const Eigen::VectorXd& forces) const;

 private:
  ContactRows rows_;
  Table<ElementIndex, UnknownBlock> flexibility_;
  Eigen::VectorXd diagonal_;
  Eigen::VectorXd added_;
};

/// The diagonal of G B Gᵀ alone.
Eigen::VectorXd diagonal_of(const ContactRows& rows, const Table<ElementIndex, UnknownBlock>& flexibility);

/// A row of G times B, for entries of W where a few are wanted: entry (i, j) is row i times row j, without what was added.
class RowThrough {
 public:
  RowThrough(const ContactRow& row, const Table<ElementIndex, UnknownBlock>& flexibility);
  double times(const ContactRow& other) const;

 private:
  ContactRow through_;
};

}  // namespace keyblock
