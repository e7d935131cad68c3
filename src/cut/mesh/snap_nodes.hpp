// Moves nodes of a mesh onto lines that pass them closely, as the old manifold cutter does.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cut/bodies/body_graph.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// Every node nearer than `reach` to a piece of the graph moves to the nearest point of the nearest piece. Shown by the
/// samples: in the four of twelve that have moved nodes all stand at the foot of the perpendicular, none is left
/// nearer, and cut with them the pieces are those of the sample. The reach was an input of each, not known: 0.0015 w
/// suits all of them but one (w: `mesh_scale`), which asks for more than 0.0037 w. Returns the number of nodes moved.
int snap_nodes(TriangleMesh& mesh, const BodyGraph& graph, double reach);

}  // namespace keyblock
