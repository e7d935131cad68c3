// A mathematical mesh without rows: triangles as small as asked for where it matters, and larger elsewhere.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "cut/mesh/mesh_size.hpp"
#include "geometry/box.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// Delaunay refinement (Ruppert 1995; CGAL's mesher) over the box and half a side beyond: no side longer than wanted at
/// the middle of its triangle, no angle below 20.7 degrees but where two of `along` meet at a smaller one. Sides of the
/// mesh follow the segments `along`, which may cross. Nodes are numbered from the bottom, in equal heights from left to
/// right.
TriangleMesh unstructured_mesh(const Box& box, const MeshSize& size, std::span<const Segment> along = {});

}  // namespace keyblock
