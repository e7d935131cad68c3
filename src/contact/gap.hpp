// The gap of a touch and how gap and slip change with the unknowns.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/frictional_problem.hpp"
#include "contact/touch.hpp"
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

/// With the outward normal n of the edge and s the share of the edge at the foot of the corner,
///     g = n·(xP − x1),  ∂g = n·(∂xP − (1−s) ∂x1 − s ∂x2),
/// exact, the turning of n included (for a bisector, where the corners meet). The slip row is t·(∂xP − ∂x of the point of the other element that lies at xP), so
/// that angular momentum holds with an open gap too (contact-notes 2).
ContactRows contact_rows(const Model& model, const Reference& reference, const UnknownsTable& q,
                         const Touches& touches);

/// G x.
Eigen::VectorXd rates(const ContactRows& rows, const UnknownsTable& x);

/// B Gᵀ f with one block of B an element.
UnknownsTable answer(const ContactRows& rows, const Table<ElementIndex, UnknownBlock>& blocks,
                     const Eigen::VectorXd& forces);

/// W = G B Gᵀ: entries where two rows share an element that can move.
ContactMatrix contact_matrix(const ContactRows& rows, const Table<ElementIndex, UnknownBlock>& blocks);

}  // namespace keyblock
