// Draws the reactions of driven edges over their displacement.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/run_choices.hpp"
#include "result/reaction_curve.hpp"

namespace keyblock::report {

/// Returns an SVG document: the amount of each reaction over the displacement; a plateau is named below the curves.
std::string reaction_picture(const std::string& title, const std::vector<ReactionCurve>& curves,
                             const Units& units = {});

}  // namespace keyblock::report
