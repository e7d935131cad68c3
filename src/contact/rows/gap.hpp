// Computes the rows of contacts: the change of gap and slip with the unknowns. Theory:
// docs/theory/04-contact-geometry.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/find/touch.hpp"
#include "contact/rows/contact_row.hpp"

namespace keyblock {

/// Returns the rows. With the outward normal n of the edge and s the fraction of the edge at the foot of the corner,
///     g = n·(xP − x1),  ∂g = n·(∂xP − (1−s) ∂x1 − s ∂x2),
/// which is exact, with the rotation of n. The slip row is t·(∂xP − ∂x of the other element's point at xP), so that
/// angular momentum is conserved with an open gap too. For an arc, both rows use the points of both elements where a
/// corner touches an edge of the other. Between its lines they are interpolated by the angle of n; on its lines they
/// are exact.
ContactRows contact_rows(const Model& model, const Reference& reference, const UnknownsTable& q,
                         const Touches& touches);

}  // namespace keyblock
