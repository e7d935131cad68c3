// Generates a mathematical mesh without rows: triangles as small as required locally, and larger elsewhere.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "cut/mesh/mesh_size.hpp"
#include "geometry/box.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// Generates the mesh by Delaunay refinement (Ruppert 1995; CGAL's mesher) over the box and half a side beyond. No side
/// is longer than allowed at the middle of its triangle. No angle is below 20.7 degrees, unless two of `along` meet at
/// a smaller one. Sides of the mesh follow the segments `along`, which may cross. Nodes are numbered from the bottom,
/// at equal heights from left to right.
TriangleMesh unstructured_mesh(const Box& box, const MeshSize& size, std::span<const Segment> along = {});

}  // namespace keyblock
