// Cuts a triangular mesh by bodies and joints into manifold elements and physical covers.
// Theory: docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cut/bodies/body_graph.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// Treatment of a body so thin that all of its elements are lost in round-off. `stay` keeps the numbers of bodies as
/// they are in the graph; `are_left_out` renumbers the others.
enum class EmptyBodies { stay, are_left_out };

/// Returns elements triangle by triangle, and covers in the order of the mesh's nodes; covers of one node are adjacent.
/// The covers of a node are the parts of its star that are connected across sides of the mesh. A joint through the star
/// makes two covers, a joint that ends in it leaves one. A joint ends where it last meets a side of the mesh. No node
/// is moved. Throws std::invalid_argument if the mesh does not cover all bodies.
Manifold cut_cover(const BodyGraph& graph, TriangleMesh mesh, EmptyBodies empty = EmptyBodies::stay);

}  // namespace keyblock
