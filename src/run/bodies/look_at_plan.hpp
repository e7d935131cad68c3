// Checks the chains, formulas and supports of a cover plan against the bodies of a run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "model/continuum.hpp"
#include "problem/cover_plan.hpp"

namespace keyblock {

/// Adds a warning if a part of a chain is on none of these edges. Throws InputError if none of it is.
void look_at_chain(const BoundaryPart& part, const Place& place, std::string_view edges_in_words,
                   std::span<const Segment> edges, double near, Warnings& warnings);

/// Returns warnings about the chains and loads of a plan. `scenes`: bodies of a run, in sequence. Throws InputError if
/// a chain is on no boundary, if a formula is not finite, or if two prescribed displacements contradict each other.
Warnings look_at_plan(const CoverPlan& plan, const std::vector<const Continuum*>& scenes);

}  // namespace keyblock
