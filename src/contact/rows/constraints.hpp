// Computes the rows of bolts and of fixed or driven points, which hold without contact. Rows come in pairs, as for
// contacts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "contact/rows/gap.hpp"

namespace keyblock {

/// Returns rows 2i and 2i + 1 for bolt i of the model; the second end moves against the first. Along the bolt, l is its
/// current direction from the first end to the second. Then ∂(length) = l·(∂x2 − ∂x1) exactly, with the rotation of l.
/// A bolt of force f (tension positive) exerts −f times this row on the unknowns. Across (l rotated by +90°) it has no
/// force. Rows are zero for a bolt whose ends coincide. If both ends lie on one element, its row is the sum and
/// `of_edge` is zero.
ContactRows bolt_rows(const Model& model, const Reference& reference, const UnknownsTable& q);

/// Returns the current length less the initial one, per bolt.
Eigen::VectorXd elongations(const Model& model, const Reference& reference, const UnknownsTable& q);

/// Two rows of a support: a fixed point in x and y, or two rows of one block along edges.
struct HeldPair {
  ElementIndex element;
  std::array<Point, 2> starts;      ///< undeformed
  std::array<Point, 2> directions;  ///< of length 1
  std::array<TimeCurve, 2> curves;  ///< displacements; only the component along the direction counts

  bool is_point() const { return starts[0] == starts[1]; }
  bool is_same_at(double from, double to) const;
};

/// Returns the supports of elements with unknowns; elements without unknowns are fixed already. Fixed points come
/// first, then the rows of edges in pairs. If a block has a row left over, its pair repeats it.
std::vector<HeldPair> held_pairs(const Model& model);

/// Returns rows 2i and 2i + 1 for the velocities of pair i along its directions; `of_edge` is zero.
ContactRows point_rows(const Model& model, const Reference& reference, const UnknownsTable& q,
                       const std::vector<HeldPair>& pairs);

/// Returns in entries 2i and 2i + 1 the distances of pair i from its targets at `time`.
Eigen::VectorXd offsets(const Model& model, const Reference& reference, const UnknownsTable& q,
                        const std::vector<HeldPair>& pairs, double time);

/// Returns in entries 2i and 2i + 1 the mean velocities that pair i requires from `time` to `time` + dt.
Eigen::VectorXd wanted_velocities(const std::vector<HeldPair>& pairs, double time, double dt);

}  // namespace keyblock
