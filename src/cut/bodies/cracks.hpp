// Cracks as slits of a graph of bodies, and the tips that slits have.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "cut/bodies/body_graph.hpp"
#include "problem/cover_plan.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// Whether every crack must lie in a body: where rock was dug out they may be gone.
enum class CracksOutside { are_refused, are_gone };

/// Adds each crack behind the other pieces of the graphs of which a body holds some of it: not in the drawing, whose
/// cutting would merge and prune them. An end that rounding alone keeps from an outline or another slit is prolonged
/// across it. Throws InputError for a chain without length, for one of which nothing lies in a body, and for one that
/// runs along an outline, a joint or another crack.
void add_cracks(std::span<BodyGraph> graphs, std::span<const CrackPlan> cracks, CracksOutside outside);

/// The ends of slits that lie inside a body and on nothing else, in the order of the pieces.
std::vector<CrackTip> tips_of(const BodyGraph& graph);

/// Whether a body of the graph holds the point.
bool is_in_a_body(const BodyGraph& graph, Point p);

}  // namespace keyblock
