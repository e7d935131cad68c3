// Maps a first-order manifold element onto block unknowns: its affine motion follows from the displacements of its
// three nodes. Theory: docs/theory/13-shis-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "model/model.hpp"
#include "model/state.hpp"

namespace keyblock {

/// Returns A, 6 × 6: the unknowns u, v, r, ex, ey, gxy of an affine field about `centroid`. The field has the
/// displacements (x1, y1, x2, y2, x3, y3) in the corners of a triangle. The centroid may lie outside it.
Eigen::Matrix<double, 6, 6> affine_from_corners(const std::array<Point, 3>& corners, Point centroid);

/// Returns A of an element for the current positions of its nodes and centroid.
Eigen::Matrix<double, 6, 6> affine_from_nodes(const Element& element, Point centroid, const State& state);

/// Returns the model with Shi's basis for all elements; elements with nodes take its unknowns from them.
Model with_affine_elements(Model model);

/// Returns the nodes at their initial positions with the velocity of their body: that of its material, with rotation
/// about the centroid.
std::vector<NodeState> start_nodes(const Model& model, const Table<ElementIndex, ElementState>& elements);

/// Sets the velocities of elements with nodes from those of the nodes.
void hang_velocities(const Model& model, State& state);

}  // namespace keyblock
