// Computes the motion of points of an element by its unknowns, with first-order or exact rotation. Theory:
// docs/theory/13-shis-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/contact/judge.hpp"
#include "model/state.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Returns the displacement of the point at `offset` from the centroid. Exact: the finite rotation X(cos r - 1) - Y sin
/// r, X sin r + Y(cos r - 1) replaces the part of r in T d. Strains are not rotated (legacy-rules 12; Shi 1988 has the
/// first-order form).
Point displacement(const Basis& basis, const Unknowns& increment, Point offset, Rotation rotation);

/// Element whose vertex moves farthest in a step, with that displacement: NaN if one displacement is NaN.
struct FarthestElement {
  ElementIndex element;
  double displacement = 0;
};
FarthestElement farthest_element(const Model& model, const State& state, const Increments& increments,
                                 Rotation rotation);

}  // namespace keyblock
