// Prescribed displacements that meet: what one says of a shared point the other must not deny.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/continuum.hpp"
#include "model/model.hpp"
#include "problem/cover_plan.hpp"

namespace keyblock {

/// Throws InputError at the later of two prescribed displacements of the plan that hold the same component of the same
/// point of a body and prescribe different values there, by more than 1e-9 of the largest that either has. `scenes` are
/// the bodies of a run, one after another. Bodies that lie side by side, and the two faces of a joint, share no point.
void require_agreement(const CoverPlan& plan, const std::vector<const Continuum*>& scenes);

/// Throws InputError at a prescribed displacement that moves a fixed point of an NMM body, which stays where it is.
void require_agreement(const CoverPlan& plan, const Model& model);

}  // namespace keyblock
