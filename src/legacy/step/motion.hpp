// How the points of an element move with its unknowns: to first order in the rotation, or with the rotation exact.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/contact/judge.hpp"
#include "model/state.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Displacement of the point at `offset` from the centroid. Exact: the part of r in T d is replaced by the
/// finite rotation X(cos r - 1) - Y sin r, X sin r + Y(cos r - 1); strains are not rotated (legacy-rules 12;
/// Shi 1988 has the first-order form).
Point displacement(const Basis& basis, const Unknowns& increment, Point offset, Rotation rotation);

/// The element of which a vertex moves furthest in a step, and how far: not a number where one is none.
struct FarthestElement {
  ElementIndex element;
  double displacement = 0;
};
FarthestElement farthest_element(const Model& model, const State& state, const Increments& increments,
                                 Rotation rotation);

}  // namespace keyblock
