// Elements that hang on nodes: a first-order manifold element moves as a block does, by the displacements of three
// nodes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "model/model.hpp"
#include "model/state.hpp"

namespace keyblock {

/// A, 6 × 6: the unknowns u, v, r, ex, ey, gxy of the affine field about `centroid` that has the displacements
/// (x1, y1, x2, y2, x3, y3) in the corners of a triangle. The centroid may lie outside it.
Eigen::Matrix<double, 6, 6> affine_from_corners(const std::array<Point, 3>& corners, Point centroid);

/// A of an element as its nodes and its centroid lie now.
Eigen::Matrix<double, 6, 6> affine_from_nodes(const Element& element, Point centroid, const State& state);

/// The same model with Shi's basis for all elements; those that hang on nodes take its unknowns from them.
Model with_affine_elements(Model model);

/// Nodes where they lie at the start, with the velocity of the body that they belong to: that of its material, turning
/// about its centroid.
std::vector<NodeState> start_nodes(const Model& model, const Table<ElementIndex, ElementState>& elements);

/// Gives elements that hang on nodes the velocity of these.
void hang_velocities(const Model& model, State& state);

}  // namespace keyblock
