// How long a trial of strength reduction may take before it is given up as undecided.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>

namespace keyblock {

/// Seconds; nothing: no limit. `asked`: 0 for none. Where nothing is asked for it is more than trials take whose
/// contact forces settle: a minute, in proportion beyond 6,000 unknowns, and ten times the longest trial before that
/// was decided, for those near the factor sought take longer than the first.
inline std::optional<double> trial_limit(std::optional<double> asked, int unknowns, double longest_before) {
  constexpr double kLeast = 60;
  constexpr double kPerUnknown = 0.01;
  constexpr double kTimesLongest = 10;
  if (asked) return *asked > 0 ? asked : std::nullopt;
  return std::max({kLeast, kPerUnknown * unknowns, kTimesLongest * longest_before});
}

}  // namespace keyblock
