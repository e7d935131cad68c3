// Extracts the reactions of driven edges from a history, and decides if they have reached a limit.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "result/history.hpp"

namespace keyblock {

/// Reaction of one prescribed displacement as it grows: the rows of the history in which it is larger than before.
struct ReactionCurve {
  std::size_t number = 0;  ///< of the prescribed displacement, from 0
  char component = 'x';    ///< the greater component of the reaction at the end
  std::vector<int> steps;
  std::vector<double> driven;    ///< length
  std::vector<double> reaction;  ///< force on the bodies, per unit thickness
  bool is_at_end = true;         ///< the last row of the history is its last row
};

/// Returns the curves of all edges that were driven.
std::vector<ReactionCurve> reaction_curves(const History& history);

/// Returns the relative growth of the reaction over that of the displacement in the last row, 1 in elastic rock.
/// Returns nothing if the displacement did not grow in it, or if the reaction is zero.
std::optional<double> end_slope(const ReactionCurve& curve);

/// Returns the row (of the curve) from which on the reaction is constant. The slope must be below 0.005 in each row
/// since, and in three at least, over which the displacement grows by a tenth, for any length of steps. Returns nothing
/// if the reaction is not constant at the end: a longer run might reach a higher one.
std::optional<std::size_t> plateau_of(const ReactionCurve& curve);

}  // namespace keyblock
