// Compares cost and error of runs: finds the Pareto front and chooses from it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace keyblock::study {

/// Cost and error of one run. A failed run has infinite error and is never on the Pareto front.
struct Price {
  double seconds = 0;  ///< of processor time
  double error = 0;    ///< relative, ≥ 0
};

/// Returns the Pareto front, cheapest first: runs for which no other is as cheap and as accurate, and better in one of
/// both. Of equal runs the first counts.
std::vector<std::size_t> pareto_front(const std::vector<Price>& prices);

/// Returns the cost of a run over the cheapest that is as accurate: 1 on the front, infinite without a result.
double over_front(const std::vector<Price>& prices, std::size_t which);

/// Noise of timings: a run whose cost is within this factor of the front counts as near it.
inline constexpr double kTimingNoise = 1.1;

/// Limits of a user on time and error. Empty: no limit.
struct Wish {
  std::optional<double> budget;  ///< seconds of processor time
  std::optional<double> error;
};

/// Returns the cheapest run within the error, or, if only a budget is set, the most accurate within it; empty if no run
/// fits. Of runs with equal cost within the noise of timing the first is chosen, so that luck does not decide.
std::optional<std::size_t> choice_for(const std::vector<Price>& prices, const Wish& wish);

}  // namespace keyblock::study
