// Adds cracks to a graph of bodies as slits, and finds the tips of slits.
// Theory: docs/theory/10-fracture.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "cut/bodies/body_graph.hpp"
#include "problem/cover_plan.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// States if a crack outside all bodies is an error; after an excavation its rock may be gone.
enum class CracksOutside { are_refused, are_gone };

/// Appends each crack to the graphs whose bodies hold a part of it. Cracks are not part of the drawing, because cutting
/// would merge and prune them. An end that misses an outline or another slit by rounding alone is prolonged across it.
/// Throws InputError for a chain without length and for a crack along an outline, a joint or another crack. Throws it
/// for a crack outside all bodies, unless `outside` allows these.
void add_cracks(std::span<BodyGraph> graphs, std::span<const CrackPlan> cracks, CracksOutside outside);

/// Returns the ends of slits that lie inside a body and on no other piece, in the order of the pieces.
std::vector<CrackTip> tips_of(const BodyGraph& graph);

/// Returns true if a body of the graph holds the point.
bool is_in_a_body(const BodyGraph& graph, Point p);

}  // namespace keyblock
