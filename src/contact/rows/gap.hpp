// The gap of a touch and how gap and slip change with the unknowns.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/find/touch.hpp"
#include "contact/rows/contact_row.hpp"

namespace keyblock {

/// With the outward normal n of the edge and s the share of the edge at the foot of the corner,
///     g = n·(xP − x1),  ∂g = n·(∂xP − (1−s) ∂x1 − s ∂x2),
/// exact, the turning of n included. The slip row is t·(∂xP − ∂x of the point of the other element that lies at xP), so
/// that angular momentum holds with an open gap too. On an arc both rows are of the points of both elements that lie
/// where one corner touches an edge of the other one, between two such places by the turn of n: exact on its lines.
ContactRows contact_rows(const Model& model, const Reference& reference, const UnknownsTable& q,
                         const Touches& touches);

}  // namespace keyblock
