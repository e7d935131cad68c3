// Solves a large symmetric positive system by CHOLMOD, and recomputes the true residual.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "system/solve.hpp"
#include "system/cholmod/sparse_factor.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

/// Its residual is relative to SparseSystem::size_of_loads().
struct SparseSolution : Solution {
  int refinements = 0;
  double factor_entries = 0;
};

/// Solves with the factorisation of its matrix, refined until the residual no longer falls. Throws NotPositiveDefinite
/// for a load that the matrix cannot carry.
SparseSolution solve(const SparseSystem& system, const SparseFactor& factor);

/// Solves with a factorisation made for it. Throws NotPositiveDefinite.
SparseSolution solve(const SparseSystem& system, Definiteness definiteness);

}  // namespace keyblock
