// Grades meshes, regular or not: halves triangles repeatedly where they must be smaller.
// Theory: docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "cut/mesh/unstructured_mesh.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// Bisects triangles by their newest vertex until no triangle has a side longer than `size` at its middle (Mitchell
/// 1991). The closure by marked edges follows Funken, Praetorius & Wissgott (2011). The first halving cuts the longest
/// side, of equal ones the one along `rows`; no angle of an equilateral mesh falls below 30 degrees. The mesh stays
/// conforming, nodes keep their numbers, and each new triangle lies in one old one. Returns the number of nodes added.
/// Throws std::invalid_argument if there would be more triangles than `kMostTriangles`.
int bisect(TriangleMesh& mesh, const MeshSize& size, Point rows);

/// Bisects the triangles that hold one of the points, inside or on their edges, until none of their sides is longer
/// than `side`. Other triangles are halved only to keep the mesh conforming. Returns the number of nodes added.
int bisect_at(TriangleMesh& mesh, std::span<const Point> points, double side, Point rows);

inline constexpr double kMostTriangles = 4e6;  ///< per mesh: minutes and gigabytes

/// Moves a node near each point onto it, unless an angle around it would fall below 15 degrees. A node is moved once;
/// nodes on the edge of the mesh stay. Returns the number of points that have a node.
int place_nodes(TriangleMesh& mesh, std::span<const Point> points);

}  // namespace keyblock
