// Moves nodes of a mesh onto lines that pass them closely, as Shi's manifold cutter does.
// Theory: docs/theory/13-shis-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cut/bodies/body_graph.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// Moves every node nearer than `reach` to a piece of the graph to the nearest point of the nearest piece. Shi's
/// samples show this rule: four of twelve have moved nodes. All of these stand at the foot of the perpendicular, no
/// node is left nearer, and cut with them the pieces are those of the sample. The reach was an input of each, which is
/// not known: 0.0015 w (`mesh_scale`) suits all samples except one, which needs more than 0.0037 w. Returns the number
/// of nodes moved.
int snap_nodes(TriangleMesh& mesh, const BodyGraph& graph, double reach);

}  // namespace keyblock
