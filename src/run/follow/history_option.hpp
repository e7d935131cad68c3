// Parses the command-line option that requests a history.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/output_plan.hpp"
#include "problem/problem.hpp"

namespace keyblock {

/// Parses `point:X,Y`, `block:N`, `contact:A,B`, `joint:N`, `line:X1,Y1,X2,Y2` or `bolt:N`, with an optional prefix
/// `NAME=`. Blocks, joints and bolts are numbered from 1. Throws std::invalid_argument.
HistoryPlan history_of(const std::string& text);

/// Adds the points of histories as measured points after those of the problem, so that they move with their body.
/// Throws InputError for a point in no block, at `place` if its plan has no place.
Problem with_followed_points(Problem problem);

}  // namespace keyblock
