// What edges that a run drives push back, and whether that has come to a limit.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "result/history.hpp"

namespace keyblock {

/// The reaction of one prescribed displacement as it grows: of its rows those in which it is further than before.
struct ReactionCurve {
  std::size_t number = 0;  ///< of the prescribed displacement, from 0
  char component = 'x';    ///< that of the reaction which is the greater at the end
  std::vector<int> steps;
  std::vector<double> driven;    ///< length
  std::vector<double> reaction;  ///< force on the bodies, per unit thickness
  bool is_at_end = true;         ///< the last row of the history is the last of these
};

/// Of all edges that were driven.
std::vector<ReactionCurve> reaction_curves(const History& history);

/// In the last row: relative growth of the reaction over that of the displacement, 1 in elastic rock; none where it was
/// not driven in it, or nothing pushes back.
std::optional<double> end_slope(const ReactionCurve& curve);

/// The row (of the curve) from which on the reaction stands: in each since, and in three at least over which the edge
/// goes a tenth further, its slope is below 0.005, however short the steps are. None where it does not stand at the
/// end: a longer run might find more.
std::optional<std::size_t> plateau_of(const ReactionCurve& curve);

}  // namespace keyblock
