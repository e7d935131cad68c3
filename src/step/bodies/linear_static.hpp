// Computes the static solution of linear elastic NMM bodies. Theory: docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuum.hpp"
#include "step/bodies/closed_faces.hpp"
#include "system/sparse_solve.hpp"
#include "terms/ghost_penalty.hpp"

namespace keyblock {

struct ContinuumSolution {
  CoverBasis basis;
  SparseSolution solution;              ///< its x: the unknowns (dx, dy) of all functions
  std::vector<FaceContact> faces = {};  ///< contacts between crack faces
  bool faces_settled = true;            ///< the forces of all crack faces converged

  int unknown_count() const { return static_cast<int>(solution.x.size()); }
  Point displacement(int element, Point x) const;
  /// Returns the engineering strain (ex, ey, gxy).
  Eigen::Vector3d strain(int element, Point x) const;
  /// Returns the skew part of the displacement gradient, (∂v/∂x - ∂u/∂y)/2 [rad]; a rotation only if small.
  double rotation(int element, Point x) const;
};

/// Returns the groups of coupled functions: those of each element, and of both elements of each pair.
FunctionGroups coupled_functions(const CoverBasis& basis, const std::vector<GhostPair>& pairs);

/// Returns the definiteness of matrices with these functions: linear and quadratic functions depend on each other.
Definiteness definiteness_of(CoverFunctions functions);

/// Adds prescribed displacements, point springs and loads.
void add_supports_and_loads(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system);

/// Assembles all terms.
SparseSystem assemble_static(const Continuum& continuum, const CoverBasis& basis);

/// Assembles and solves the system. If crack faces touch, it is solved once more with their contact forces. `joints`:
/// joint materials of the faces. Throws NotPositiveDefinite if a body can still move.
ContinuumSolution solve_static(const Continuum& continuum, const std::vector<JointMaterial>& joints = {});

ForceBalance balance_of(const Continuum& continuum, const ContinuumSolution& solution);

/// Returns the stress at a point, tension positive, with the initial stress. It follows from the raw strain there,
/// without recovery or averaging.
Stress stress_at(const Continuum& continuum, const ContinuumSolution& solution, int element, Point x);

}  // namespace keyblock
