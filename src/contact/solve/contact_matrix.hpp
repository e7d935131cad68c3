// What forces of contacts and ties do to the rates along them, without the matrix of that ever being formed for blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "contact/rows/contact_row.hpp"
#include "contact/solve/block_numbers.hpp"
#include "contact/solve/pair_system.hpp"

namespace keyblock {

/// G B Gᵀ by way of the covers alone, which couple every row that they have a part in: dense, a solution a row.
class CoverCoupling {
 public:
  CoverCoupling() = default;
  CoverCoupling(const ContactRows& rows, const Flexibility& flexibility);

  bool is_none() const { return places_.empty(); }
  double entry(Eigen::Index i, Eigen::Index j) const;
  /// Row i times forces.
  double rate(Eigen::Index i, const Eigen::VectorXd& forces) const;
  /// All rows times forces.
  Eigen::VectorXd times(const Eigen::VectorXd& forces) const;

 private:
  std::vector<Eigen::Index> places_;  ///< of each row in the matrix; −1 where covers have no part in it
  std::vector<Eigen::Index> rows_;    ///< the other way
  Eigen::MatrixXd matrix_;
};

/// W = G B Gᵀ + diag(added), with a row of G a force and a block of B an element: the flexibility of its unknowns,
/// symmetric, zero in rows and columns of unknowns that do not answer. Those that do come first. Covers have one common
/// part of B.
class ContactMatrix {
 public:
  ContactMatrix() = default;
  ContactMatrix(ContactRows rows, Flexibility flexibility);
  /// The same rows as others have.
  ContactMatrix(std::shared_ptr<const ContactRows> rows, Flexibility flexibility);

  Eigen::Index rows() const { return diagonal_.size(); }
  const Eigen::VectorXd& diagonal() const { return diagonal_; }
  const ContactRow& row(Eigen::Index i) const { return (*rows_)[static_cast<std::size_t>(i)]; }
  const Flexibility& flexibility() const { return flexibility_; }
  const CoverCoupling& covers() const { return covers_; }
  const Eigen::VectorXd& added() const { return added_; }
  /// Made when first asked for.
  const BlockNumbers& blocks() const;
  /// The same rows for products many times over; none for few blocks or pairs, or where covers couple rows. Made
  /// when first asked for.
  const PairSystem* pairs() const;

  /// The compliance of a spring, 1/p.
  void add_to_diagonal(Eigen::Index row, double value);

  Eigen::VectorXd operator*(const Eigen::VectorXd& forces) const;

 private:
  std::shared_ptr<const ContactRows> rows_ = std::make_shared<ContactRows>();
  Flexibility flexibility_;
  CoverCoupling covers_;
  Eigen::VectorXd diagonal_;
  Eigen::VectorXd added_;
  mutable std::shared_ptr<const BlockNumbers> blocks_;
  bool has_many_pairs_ = false;
  mutable std::shared_ptr<const PairSystem> pairs_;
};

/// The diagonal of G B Gᵀ alone, with what covers couple made already.
Eigen::VectorXd diagonal_of(const ContactRows& rows, const Flexibility& flexibility, const CoverCoupling& covers);

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
