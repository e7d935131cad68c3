// Cuts a triangular mesh by bodies and joints into manifold elements and physical covers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cut/bodies/body_graph.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// A body so thin that all of its elements are lost in round-off: it stays, without elements, so that bodies count as
/// they do in the graph, or the others are numbered on without it.
enum class EmptyBodies { stay, are_left_out };

/// Elements triangle by triangle; covers in the order of the mesh's nodes, those that share a node adjacent. The covers
/// of a node are the parts of its star that hang together across sides of the mesh: a joint through the star makes two,
/// one that ends in it leaves one. A joint is taken to end where it last meets a side of the mesh. Nothing is moved.
/// Throws std::invalid_argument where the mesh does not cover all bodies.
Manifold cut_cover(const BodyGraph& graph, TriangleMesh mesh, EmptyBodies empty = EmptyBodies::stay);

}  // namespace keyblock
