// Computes the rows of bolts and of fixed or driven points, which hold without contact. Rows come in pairs, as for
// contacts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// Returns the fixed points of elements with unknowns; elements without unknowns are fixed already.
std::vector<CarriedPoint> held_points(const Model& model);

/// Returns rows 2i and 2i + 1 for the velocity of point i in x and y; `of_edge` is zero.
ContactRows point_rows(const Model& model, const Reference& reference, const UnknownsTable& q,
                       const std::vector<CarriedPoint>& points);

/// Returns in entries 2i and 2i + 1 the distance of point i from its target at `time`, in x and y.
Eigen::VectorXd offsets(const Model& model, const Reference& reference, const UnknownsTable& q,
                        const std::vector<CarriedPoint>& points, double time);

/// Returns in entries 2i and 2i + 1 the mean velocity that point i requires from `time` to `time` + dt.
Eigen::VectorXd wanted_velocities(const std::vector<CarriedPoint>& points, double time, double dt);

}  // namespace keyblock
