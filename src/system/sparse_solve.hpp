// One call that solves a large symmetric positive system by CHOLMOD and says how well: the true residual is recomputed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

#include "system/solve.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

/// The factorisation met a pivot that is not positive.
class NotPositiveDefinite : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class Definiteness {
  definite,
  semidefinite,  ///< unknowns may depend on each other; the load lies in the range of the matrix
};

struct SparseSolution : Solution {
  int refinements = 0;
  double factor_entries = 0;
};

/// Supernodal L Lᵀ of the matrix scaled to a diagonal of ones, refined until the residual no longer falls. A semidefinite
/// matrix is factorised with 1e-11 added to its diagonal; refinement takes that out again (Strouboulis, Babuška & Copps
/// 2000): what it leaves undetermined is a combination of unknowns that makes no displacement. Throws NotPositiveDefinite.
SparseSolution solve(const SparseSystem& system, Definiteness definiteness);

}  // namespace keyblock
