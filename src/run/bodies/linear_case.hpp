// Cases whose load steps are linear static solutions: which they are, and what of them such a solution knows.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "problem/problem.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Whether a case has bodies on covers of which each load step is one linear solution: statics in which nothing
/// touches, or only faces of cracks do whose tips have functions, no point is held or loaded and no bolt ties bodies,
/// or contact is ignored, or `covers` dig something out.
/// Throws InputError where something is dug out and the case is no statics of `standard`.
bool is_untouched(const Problem& problem, const Settings& settings);

/// Whether faces of cracks touch in a case that is linear: their tips have functions, and contact is felt.
bool faces_touch(const Problem& problem);

/// Throws InputError for a case with functions at the tips of cracks whose steps are not linear static solutions in
/// elastic rock with derived or linear functions and cracks as they are, and where joints hold the faces of cracks
/// together that touch.
void require_linear_tips(const Problem& problem, const Settings& settings);

struct LinearCase {
  Problem problem;         ///< without points and bolts that have no effect; what is dug out begins a stage
  std::vector<int> steps;  ///< of each stage; none where nothing is dug out
  Warnings warnings;       ///< of what has no effect
};

/// Of a case that is linear. Throws InputError for an excavation beyond the last load step.
LinearCase linear_case(const Problem& problem, const Settings& settings);

}  // namespace keyblock
