// What is followed in time, as an option of the command line says it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/output_plan.hpp"
#include "problem/problem.hpp"

namespace keyblock {

/// `point:X,Y`, `block:N`, `contact:A,B`, `joint:N`, `line:X1,Y1,X2,Y2` or `bolt:N`, with `NAME=` before it where it is
/// to have a name; numbers of blocks, joints and bolts from 1. Throws std::invalid_argument.
HistoryPlan history_of(const std::string& text);

/// The points of histories as measured points, behind those of the problem: they travel with what they lie in. Throws
/// InputError for one that lies in no block, `place` where its plan has none.
Problem with_followed_points(Problem problem);

}  // namespace keyblock
