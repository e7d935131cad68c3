// A cover file's elements, covers and loops as the cut mesh that they came from.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cut/bodies/body_graph.hpp"
#include "problem/cover.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// The inverse of `to_cover`, for files of the old cutter too. Elements and covers keep their numbers. Covers at one
/// position are of one node; the triangles are those that elements name by their covers. An edge in no loop leads to
/// the element that has its reverse, to the bit, and shares two covers or more: small pieces that the old cutter gave
/// the covers of a neighbour share all three, and lie outside their triangle. Bodies are the parts that hang together
/// through such edges and have one material (-1 where the file assigns none). A bridge to a hole and back becomes a
/// hole again. Throws InputError where an edge is neither, a loop leaves the edges of elements, or a triangle is not
/// counter-clockwise.
Manifold manifold_of(const Cover& cover);

/// The outlines of the bodies, with the joints that end inside them as slits, in pieces from corner to corner of the
/// elements: what cuts another mesh as the old one was cut.
BodyGraph body_graph_of(const Manifold& manifold);

/// The points of the file.
ElementPoints points_of(const Cover& cover);

}  // namespace keyblock
