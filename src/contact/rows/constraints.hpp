// Constraints between elements, or of an element to the plane, that hold without touching: bolts, and points that are
// held or driven. Their rows are pairs as those of a touch are.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "contact/rows/gap.hpp"

namespace keyblock {

/// Rows 2i and 2i + 1 belong to bolt i of the model; the second end moves against the first. Along the bolt, with l its
/// present direction from the first end to the second, ∂(length) = l·(∂x2 − ∂x1) exactly, the turning of l included. A
/// bolt of force f (tension positive) puts −f times this row on the unknowns. Across (l turned by +90°) it has no
/// force. A bolt whose ends meet has no direction: zero rows. Where both ends are on one element the row of that
/// element is the sum, and `of_edge` is zero.
ContactRows bolt_rows(const Model& model, const Reference& reference, const UnknownsTable& q);

/// Present length less that at the start, one a bolt.
Eigen::VectorXd elongations(const Model& model, const Reference& reference, const UnknownsTable& q);

/// The fixed points of elements that have unknowns; elements without are held already.
std::vector<CarriedPoint> held_points(const Model& model);

/// Rows 2i and 2i + 1: the velocity of point i in x and y against the plane; `of_edge` is zero.
ContactRows point_rows(const Model& model, const Reference& reference, const UnknownsTable& q,
                       const std::vector<CarriedPoint>& points);

/// Entries 2i and 2i + 1: how far point i lies from where its motion wants it at `time`, in x and y.
Eigen::VectorXd offsets(const Model& model, const Reference& reference, const UnknownsTable& q,
                        const std::vector<CarriedPoint>& points, double time);

/// Entries 2i and 2i + 1: the mean velocity that the motion of point i asks for from `time` to `time` + dt.
Eigen::VectorXd wanted_velocities(const std::vector<CarriedPoint>& points, double time, double dt);

}  // namespace keyblock
