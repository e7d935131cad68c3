// The mathematical mesh that a plan asks for, laid over bodies.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "cut/bodies/body_graph.hpp"
#include "cut/mesh/background_mesh.hpp"
#include "cut/mesh/unstructured_mesh.hpp"
#include "geometry/box.hpp"

namespace keyblock {

inline constexpr int kMostHalfRows = 1000;  ///< of a regular mesh: some four million triangles

/// Of sides per length from a refined point or tip of a bisected mesh: a quarter costs twice the triangles.
inline constexpr double kMeshGrowth = 0.5;
inline constexpr double kUnstructuredGrowth = 0.3;  ///< the same of an unstructured mesh

struct FittedMesh {
  TriangleMesh mesh;
  int snapped = 0;  ///< nodes moved onto lines
};

/// The box about all bodies.
Box box_of(const BodyGraph& graph);

/// Corners of shorter sides would fall on one another.
double least_side(const Box& box);

/// The mesh over all bodies: refined as the plan says at its points and at the tips of cracks, each of which gets a
/// node where the plan says a side or functions there and that leaves sound triangles. Throws std::invalid_argument
/// where a length of the plan is none, or the mesh would be too large.
FittedMesh fitted_mesh(const MeshPlan& plan, const BodyGraph& graph, std::span<const Point> tips = {});

/// The same of a mesh that is there already, as in a cover file: refined where the plan says, by its own triangles.
FittedMesh refitted_mesh(TriangleMesh mesh, const MeshPlan& plan, const BodyGraph& graph,
                         std::span<const Point> tips = {});

}  // namespace keyblock
