// What runs cost and how far off they are: the front of those that nothing beats, and the choice from it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace keyblock::study {

/// A run on the market. One that gave no result has an infinite error, and is on no front.
struct Price {
  double seconds = 0;  ///< of processor time
  double error = 0;    ///< relative, ≥ 0
};

/// The runs of which no other is as cheap and as accurate, and better in one of the two: Pareto's front, cheapest
/// first. Of equals the first given.
std::vector<std::size_t> pareto_front(const std::vector<Price>& prices);

/// What a run costs over the cheapest that is as accurate: 1 on the front, infinite without a result.
double over_front(const std::vector<Price>& prices, std::size_t which);

/// Timings differ by so much from one to the next: who costs up to this factor over the front is near it.
inline constexpr double kTimingNoise = 1.1;

/// What somebody wants: no more than so much time, no more than so much error. Nothing: does not matter.
struct Wish {
  std::optional<double> budget;  ///< seconds of processor time
  std::optional<double> error;
};

/// The cheapest run within the error, or, where only a budget is given, the most accurate within it; nothing where none
/// is. Of runs that cost the same but for the noise of timing the first given: an equal run is not chosen for its luck.
std::optional<std::size_t> choice_for(const std::vector<Price>& prices, const Wish& wish);

}  // namespace keyblock::study
