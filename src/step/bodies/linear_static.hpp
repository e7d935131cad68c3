// The static solution of a linear elastic body on covers.
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
  std::vector<FaceContact> faces = {};  ///< where those of cracks touch
  bool faces_settled = true;            ///< forces were found that all faces agree with

  int unknown_count() const { return static_cast<int>(solution.x.size()); }
  Point displacement(int element, Point x) const;
  /// Engineering strain (ex, ey, gxy).
  Eigen::Vector3d strain(int element, Point x) const;
  /// The skew part of the gradient of displacement, (∂v/∂x - ∂u/∂y)/2: rad, where it is small.
  double rotation(int element, Point x) const;
};

/// What couples: the functions of each element, and of both elements of each pair.
FunctionGroups coupled_functions(const CoverBasis& basis, const std::vector<GhostPair>& pairs);

/// Of the matrices of a kind of functions: those of linear and quadratic ones depend on each other.
Definiteness definiteness_of(CoverFunctions functions);

/// Prescribed displacements, point springs and loads.
void add_supports_and_loads(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system);

/// All terms.
SparseSystem assemble_static(const Continuum& continuum, const CoverBasis& basis);

/// All terms assembled, then one solve, and one more with the forces between faces of cracks where these touch;
/// `joints` are the joint materials of the faces. Throws NotPositiveDefinite where a body can still move.
ContinuumSolution solve_static(const Continuum& continuum, const std::vector<JointMaterial>& joints = {});

ForceBalance balance_of(const Continuum& continuum, const ContinuumSolution& solution);

/// Tension positive, the initial stress included; of the raw strain at that point, nothing recovered or averaged.
Stress stress_at(const Continuum& continuum, const ContinuumSolution& solution, int element, Point x);

}  // namespace keyblock
