// Finds cases whose load steps are linear static solutions, and drops what such a solution cannot include.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "problem/problem.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Returns true if a case has NMM bodies and each load step is one linear solution. Such a case is static, with no
/// fixed or loaded points and no bolts between bodies. Nothing is in contact, except faces of cracks whose tips have
/// functions. It is also linear if contact is ignored, or if `covers` excavates. Throws InputError if an excavation
/// occurs outside statics of `standard`.
bool is_untouched(const Problem& problem, const Settings& settings);

/// Returns true if faces of cracks are in contact in a linear case: their tips have functions, and contact is not
/// ignored.
bool faces_touch(const Problem& problem);

/// Checks cases with functions at crack tips. Throws InputError unless the steps are linear static solutions in elastic
/// rock, with derived or linear functions and cracks that do not grow. Throws also if joints bond crack faces in
/// contact.
void require_linear_tips(const Problem& problem, const Settings& settings);

struct LinearCase {
  Problem problem;         ///< without ineffective points and bolts; an excavation begins a stage
  std::vector<int> steps;  ///< of each stage; empty without excavation
  Warnings warnings;       ///< about ineffective input
};

/// Converts a linear case. Throws InputError for an excavation beyond the last load step.
LinearCase linear_case(const Problem& problem, const Settings& settings);

}  // namespace keyblock
