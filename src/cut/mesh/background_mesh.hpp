// Generates the regular mathematical mesh: rows of equal triangles over a box.
// Theory: docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/box.hpp"
#include "problem/cover_plan.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// Regular mesh: rows are `dy` apart, nodes of a row `dx`; every second row is shifted by dx/2. A node is at `through`,
/// and the rows run at `angle` to the x axis [rad]. Lengths in the unit of the drawing.
struct RegularMesh {
  double dx = 1;
  double dy = 1;
  Point through;
  double angle = 0;
};

/// Returns w = max(H/2, W/2.6), the scale of Shi's manifold cutter.
double mesh_scale(const Box& box);

/// Returns a mesh by the density rule of Shi's cutter: dy = 1.1 w/n, rows at the box's middle and to either side. The
/// n-th row from the middle has a node above the middle (legacy-formats 2.4, a fit to its samples). `half_rows`, n, is
/// at least 1.
RegularMesh centred_mesh(const Box& box, int half_rows, MeshShape shape);

/// Returns a mesh with 2n rows of triangles from the lower to the upper edge of the box, a node in its lower left
/// corner.
RegularMesh aligned_mesh(const Box& box, int half_rows, MeshShape shape);

/// Returns the triangles of the mesh over the box, and a few beyond. Nodes are numbered row by row from the bottom,
/// from left to right. An upward triangle names its lower left node first, a downward one its upper left node.
TriangleMesh regular_triangles(const Box& box, const RegularMesh& mesh);

}  // namespace keyblock
