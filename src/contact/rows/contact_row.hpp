// Rows of G: how gap and slip of contacts and constraints change with the unknowns of two elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "model/kinematics.hpp"

namespace keyblock {

/// What a unit rate of the two unknowns of a cover function does to gap or slip.
struct SharedEntry {
  int function = 0;
  double x = 0;
  double y = 0;
};

/// One row of G: what a unit rate of the unknowns of the two elements does to gap or slip. The part of an element
/// whose unknowns others share stands in `shared`, and its own row is empty.
struct ContactRow {
  using Row = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kMostUnknowns>;
  ElementIndex vertex_element;
  ElementIndex edge_element;
  Row of_vertex;
  Row of_edge;
  std::vector<SharedEntry> shared{};

  /// The product with shared unknowns.
  double of_shared(const Eigen::VectorXd& x) const;
  void add_shared(double force, Eigen::VectorXd& sum) const;
  /// Gᵀ f of this row.
  void add_to(UnknownsTable& sum, double force) const;
};

/// The unknowns of most blocks, all of them: products of a size that the compiler knows take less than half of the
/// instructions of those of any size.
using AllUnknowns = Eigen::Matrix<double, kMostUnknowns, 1>;

/// row · x of one element.
inline double product(const ContactRow::Row& row, const Unknowns& x) {
  if (row.size() != kMostUnknowns) return row.dot(x.transpose());
  return Eigen::Map<const AllUnknowns>(row.data()).dot(Eigen::Map<const AllUnknowns>(x.data()));
}

using AllOfBlock = Eigen::Matrix<double, kMostUnknowns, kMostUnknowns>;

inline Unknowns product(const UnknownBlock& a, const Unknowns& x) {
  if (x.size() != kMostUnknowns) return a * x;
  return Eigen::Map<const AllOfBlock>(a.data()) * Eigen::Map<const AllUnknowns>(x.data());
}

inline ContactRow::Row product(const ContactRow::Row& row, const UnknownBlock& a) {
  if (row.size() != kMostUnknowns) return row * a;
  return Eigen::Map<const AllUnknowns>(row.data()).transpose() * Eigen::Map<const AllOfBlock>(a.data());
}

/// Adds rowᵀ f.
inline void add_scaled(double f, const ContactRow::Row& row, Unknowns& sum) {
  if (row.size() == kMostUnknowns)
    Eigen::Map<AllUnknowns>(sum.data()) += f * Eigen::Map<const AllUnknowns>(row.data());
  else
    sum += f * row.transpose();
}

/// Rows 2i (normal) and 2i + 1 (tangential) belong to touch i.
using ContactRows = std::vector<ContactRow>;

/// G x.
Eigen::VectorXd rates(const ContactRows& rows, const UnknownsTable& x);

/// How all shared unknowns answer to forces on them.
class SharedFlexibility {
 public:
  virtual ~SharedFlexibility() = default;
  virtual Eigen::Index size() const = 0;  ///< unknowns
  virtual bool is_symmetric() const { return true; }
  /// B f, a column a load.
  virtual Eigen::MatrixXd times(const Eigen::MatrixXd& forces) const = 0;
};

/// The same, times a factor; none of none.
std::shared_ptr<const SharedFlexibility> scaled(std::shared_ptr<const SharedFlexibility> flexibility, double factor);

/// B: a block for each element, and an operator for what elements share.
struct Flexibility {
  Table<ElementIndex, UnknownBlock> blocks;
  std::shared_ptr<const SharedFlexibility> shared{};
  bool has_symmetric_blocks = true;  ///< false: that of a block that flows not normal to its surface is not
  Table<ElementIndex, UnknownBlock> inverses{};  ///< of `blocks`, where they are known; else empty
};

/// B Gᵀ f of the blocks alone; shared unknowns are left out.
UnknownsTable answer_of_blocks(const ContactRows& rows, const Table<ElementIndex, UnknownBlock>& blocks,
                               const Eigen::VectorXd& forces);

/// B Gᵀ f.
UnknownsTable answer(const ContactRows& rows, const Flexibility& flexibility, const Eigen::VectorXd& forces);

}  // namespace keyblock
