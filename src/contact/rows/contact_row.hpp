// Defines the rows of G: the change of gap and slip of contacts and constraints with the unknowns of two elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "model/kinematics.hpp"

namespace keyblock {

/// Rate of gap or slip per unit rate of the two unknowns of a cover function.
struct SharedEntry {
  int function = 0;
  double x = 0;
  double y = 0;
};

/// Row of G: rate of gap or slip per unit rate of the unknowns of two elements. If an element shares its unknowns, its
/// part is in `shared` and its own row is empty.
struct ContactRow {
  using Row = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kMostUnknowns>;
  ElementIndex vertex_element;
  ElementIndex edge_element;
  Row of_vertex;
  Row of_edge;
  std::vector<SharedEntry> shared{};

  /// Returns the product with shared unknowns.
  double of_shared(const Eigen::VectorXd& x) const;
  void add_shared(double force, Eigen::VectorXd& sum) const;
  /// Adds Gᵀ f of this row.
  void add_to(UnknownsTable& sum, double force) const;
};

/// Unknowns of a full block, the usual case. Products of a size known to the compiler take less than half the
/// instructions.
using AllUnknowns = Eigen::Matrix<double, kMostUnknowns, 1>;

/// Returns row · x of one element.
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

/// Rows 2i (normal) and 2i + 1 (tangential) belong to contact i.
using ContactRows = std::vector<ContactRow>;

/// Returns G x.
Eigen::VectorXd rates(const ContactRows& rows, const UnknownsTable& x);

/// Response of all shared unknowns to forces on them.
class SharedFlexibility {
 public:
  virtual ~SharedFlexibility() = default;
  virtual Eigen::Index size() const = 0;  ///< number of unknowns
  virtual bool is_symmetric() const { return true; }
  /// Returns B f, one column per load.
  virtual Eigen::MatrixXd times(const Eigen::MatrixXd& forces) const = 0;
};

/// Returns the same times a factor; null stays null.
std::shared_ptr<const SharedFlexibility> scaled(std::shared_ptr<const SharedFlexibility> flexibility, double factor);

/// Flexibility B: one block per element, and an operator for shared unknowns.
struct Flexibility {
  Table<ElementIndex, UnknownBlock> blocks;
  std::shared_ptr<const SharedFlexibility> shared{};
  bool has_symmetric_blocks = true;              ///< false if blocks have non-associated flow
  Table<ElementIndex, UnknownBlock> inverses{};  ///< of `blocks` if known; otherwise empty
};

/// Returns B Gᵀ f of the blocks alone, without shared unknowns.
UnknownsTable answer_of_blocks(const ContactRows& rows, const Table<ElementIndex, UnknownBlock>& blocks,
                               const Eigen::VectorXd& forces);

/// Returns B Gᵀ f.
UnknownsTable answer(const ContactRows& rows, const Flexibility& flexibility, const Eigen::VectorXd& forces);

}  // namespace keyblock
