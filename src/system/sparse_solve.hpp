// One call that solves a large symmetric positive system by CHOLMOD and says how well: the true residual is recomputed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "system/solve.hpp"
#include "system/cholmod/sparse_factor.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

struct SparseSolution : Solution {
  int refinements = 0;
  double factor_entries = 0;
};

/// By the factor of its matrix, refined until the residual no longer falls. Throws NotPositiveDefinite for a load that
/// the matrix cannot carry.
SparseSolution solve(const SparseSystem& system, const SparseFactor& factor);

/// The same by a factor made for it. Throws NotPositiveDefinite.
SparseSolution solve(const SparseSystem& system, Definiteness definiteness);

}  // namespace keyblock
