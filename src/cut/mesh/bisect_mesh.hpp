// Graded meshes: triangles halved again and again where they are to be smaller, for regular meshes as for any others.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "cut/mesh/unstructured_mesh.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// Newest-vertex bisection (Mitchell 1991; the closure by marked edges as in Funken, Praetorius & Wissgott 2011) until
/// no triangle has a side longer than `size` wants in its middle. The first halving cuts the longest side, of equal
/// ones that along `rows`: of equilateral triangles no angle falls below 30 degrees. The mesh stays conforming, its
/// nodes stay and keep their numbers, each new triangle lies in one old one. Returns the number of nodes added.
/// Throws std::invalid_argument where there would be more triangles than `kMostTriangles`.
int bisect(TriangleMesh& mesh, const MeshSize& size, Point rows);

/// The same of the triangles that hold one of the points, inside or at their rim, until none of their sides is longer
/// than `side`. Sides elsewhere only as conformity asks for. Returns the number of nodes added.
int bisect_at(TriangleMesh& mesh, std::span<const Point> points, double side, Point rows);

inline constexpr double kMostTriangles = 4e6;  ///< of any mesh: minutes and gigabytes

/// Moves a node near each point onto it, unless an angle about it would fall below 15 degrees; a node is moved once,
/// and those on the rim of the mesh stay. Returns the number of points that have a node.
int place_nodes(TriangleMesh& mesh, std::span<const Point> points);

}  // namespace keyblock
