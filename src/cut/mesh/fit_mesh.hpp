// Lays the mathematical mesh of a plan over bodies.
// Theory: docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "cut/bodies/body_graph.hpp"
#include "cut/mesh/background_mesh.hpp"
#include "cut/mesh/unstructured_mesh.hpp"
#include "geometry/box.hpp"

namespace keyblock {

inline constexpr int kMostHalfRows = 1000;  ///< of a regular mesh: some four million triangles

/// Growth of sides per length from a refined point or tip of a bisected mesh; a quarter costs twice the triangles.
inline constexpr double kMeshGrowth = 0.5;
inline constexpr double kUnstructuredGrowth = 0.3;  ///< the same for an unstructured mesh

struct FittedMesh {
  TriangleMesh mesh;
  int snapped = 0;  ///< nodes moved onto lines
};

/// Returns the box around all bodies.
Box box_of(const BodyGraph& graph);

/// Returns the least side of a mesh; corners of shorter sides would coincide by rounding.
double least_side(const Box& box);

/// Returns the mesh over all bodies, refined at the points of the plan and at the tips of cracks. A tip gets a node if
/// the plan sets a side or functions there, and if that leaves sound triangles. Throws std::invalid_argument if a
/// length of the plan is not positive, or if the mesh would be too large.
FittedMesh fitted_mesh(const MeshPlan& plan, const BodyGraph& graph, std::span<const Point> tips = {});

/// Refines an existing mesh, as in a cover file, by its own triangles where the plan requires it.
FittedMesh refitted_mesh(TriangleMesh mesh, const MeshPlan& plan, const BodyGraph& graph,
                         std::span<const Point> tips = {});

}  // namespace keyblock
