// One call that solves a large symmetric positive system by CHOLMOD and says how well: the true residual is recomputed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "system/solve.hpp"
#include "system/sparse_factor.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

struct SparseSolution : Solution {
  int refinements = 0;
  double factor_entries = 0;
};

/// By `SparseFactor`, refined until the residual no longer falls. Throws NotPositiveDefinite.
SparseSolution solve(const SparseSystem& system, Definiteness definiteness);

}  // namespace keyblock
