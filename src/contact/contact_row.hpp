// Rows of G: how gap and slip of contacts and ties change with the unknowns of two elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/kinematics.hpp"

namespace keyblock {

/// One row of G: what a unit rate of the unknowns of the two elements does to gap or slip.
struct ContactRow {
  using Row = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kMostUnknowns>;
  ElementIndex vertex_element;
  ElementIndex edge_element;
  Row of_vertex;
  Row of_edge;
};

/// Rows 2i (normal) and 2i + 1 (tangential) belong to touch i.
using ContactRows = std::vector<ContactRow>;

/// G x.
Eigen::VectorXd rates(const ContactRows& rows, const UnknownsTable& x);

/// B Gᵀ f with one block of B an element.
UnknownsTable answer(const ContactRows& rows, const Table<ElementIndex, UnknownBlock>& blocks,
                     const Eigen::VectorXd& forces);

}  // namespace keyblock
