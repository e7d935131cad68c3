// Checks that prescribed displacements agree at shared points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/continuum.hpp"
#include "model/model.hpp"
#include "problem/cover_plan.hpp"

namespace keyblock {

/// Throws InputError at the later of two contradictory prescribed displacements of the plan. They contradict if they
/// fix the same component of the same point of a body with different values. The tolerance is 1e-9 of the largest value
/// of either. `scenes`: bodies of a run, in sequence. Adjacent bodies, and the two faces of a joint, share no point.
void require_agreement(const CoverPlan& plan, const std::vector<const Continuum*>& scenes);

/// Throws InputError at a prescribed displacement that moves a fixed point of an NMM body.
void require_agreement(const CoverPlan& plan, const Model& model);

}  // namespace keyblock
