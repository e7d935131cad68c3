// Rows of G: how gap and slip of contacts and constraints change with the unknowns of two elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "model/kinematics.hpp"

namespace keyblock {

/// What a unit rate of the two unknowns of a cover function does to gap or slip.
struct CoverEntry {
  int function = 0;
  double x = 0;
  double y = 0;
};

/// One row of G: what a unit rate of the unknowns of the two elements does to gap or slip. The part of an element on
/// covers stands in `covers`, and its own row is empty.
struct ContactRow {
  using Row = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kMostUnknowns>;
  ElementIndex vertex_element;
  ElementIndex edge_element;
  Row of_vertex;
  Row of_edge;
  std::vector<CoverEntry> covers{};

  /// The product with unknowns of covers.
  double of_covers(const Eigen::VectorXd& x) const;
  void add_covers(double force, Eigen::VectorXd& sum) const;
};

/// Rows 2i (normal) and 2i + 1 (tangential) belong to touch i.
using ContactRows = std::vector<ContactRow>;

/// G x.
Eigen::VectorXd rates(const ContactRows& rows, const UnknownsTable& x);

/// How the unknowns of all covers answer to forces on them.
class CoverFlexibility {
 public:
  virtual ~CoverFlexibility() = default;
  virtual Eigen::Index size() const = 0;  ///< unknowns
  /// B f, a column a load.
  virtual Eigen::MatrixXd times(const Eigen::MatrixXd& forces) const = 0;
};

/// B: one block an element, and one for all covers.
struct Flexibility {
  Table<ElementIndex, UnknownBlock> blocks;
  std::shared_ptr<const CoverFlexibility> covers{};
};

/// B Gᵀ f of the blocks alone; nothing is said of covers.
UnknownsTable answer_of_blocks(const ContactRows& rows, const Table<ElementIndex, UnknownBlock>& blocks,
                               const Eigen::VectorXd& forces);

/// B Gᵀ f.
UnknownsTable answer(const ContactRows& rows, const Flexibility& flexibility, const Eigen::VectorXd& forces);

}  // namespace keyblock
