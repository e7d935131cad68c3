// Rebuilds the cut mesh from the elements, covers and loops of a cover file.
// Theory: docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cut/bodies/body_graph.hpp"
#include "problem/cover.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// Inverts `to_cover`, for files of Shi's cutter too. Elements and covers keep their numbers. Covers at one position
/// belong to one node; triangles are those that elements name by their covers.
///
/// An edge in no loop leads to the element that has its reverse, to the bit, and shares two covers or more. Small
/// pieces that Shi's cutter gave the covers of a neighbour share all three, and lie outside their triangle. Bodies are
/// the parts connected through such edges with one material (-1 if the file assigns none). A bridge to a hole and back
/// becomes a hole again.
///
/// Throws InputError if an edge is in no loop and has no neighbour, or if a loop leaves the edges of elements. Throws
/// it if a triangle is not counter-clockwise.
Manifold manifold_of(const Cover& cover);

/// Returns the outlines of the bodies, with the joints that end inside them as slits. Pieces run from corner to corner
/// of the elements, so that the graph cuts another mesh as it cut this one.
BodyGraph body_graph_of(const Manifold& manifold);

/// Returns the points of the file.
ElementPoints points_of(const Cover& cover);

}  // namespace keyblock
