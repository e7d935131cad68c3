// Uses one order for all values, because single ones may cross zero between two runs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/trade/extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace keyblock::study {
namespace {

constexpr double kLeastOrder = 0.4;
constexpr double kGreatestOrder = 6;
// The integrators are of first or second order. A much higher order from three runs shows terms that cancel.
constexpr double kOrderTrusted = 2;
constexpr double kOrderOfCancelling = 2.5;
// Ratio of |coarse - fine| to |middle - fine| at first order, 1 + 2. If differences cancel by chance, the fine run may
// be off by this fraction.
constexpr double kFallOfFirstOrder = 3;
constexpr double kSame = 1e-12;  // relative: round-off

// Returns the limit of a + b h + c h² from h, h/2 and h/4 (Romberg 1955).
std::vector<double> without_both_orders(const std::array<std::vector<double>, 3>& values) {
  const auto& [coarse, middle, fine] = values;
  std::vector<double> limit(fine.size());
  for (std::size_t i = 0; i < fine.size(); ++i) limit[i] = (8 * fine[i] - 6 * middle[i] + coarse[i]) / 3;
  return limit;
}

}  // namespace

double relative_distance(const std::vector<double>& a, const std::vector<double>& b) {
  double apart = 0;
  double size = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    apart += (a[i] - b[i]) * (a[i] - b[i]);
    size += b[i] * b[i];
  }
  if (b.empty()) return 0;
  return size > 0 ? std::sqrt(apart / size) : std::sqrt(apart / static_cast<double>(b.size()));
}

Limit limit_of(const std::array<std::vector<double>, 3>& values, Refined refined) {
  const auto& [coarse, middle, fine] = values;
  const double first = relative_distance(coarse, fine);
  const double second = relative_distance(middle, fine);
  Limit limit{fine, {}, false, second};
  if (first <= kSame && second <= kSame) return limit;
  std::vector<double> first_step(fine.size());
  std::vector<double> second_step(fine.size());
  double sum_first = 0;
  double sum_second = 0;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    first_step[i] = middle[i] - coarse[i];
    second_step[i] = fine[i] - middle[i];
    sum_first += first_step[i] * first_step[i];
    sum_second += second_step[i] * second_step[i];
  }
  limit.order = std::log2(sum_first / sum_second) / 2;
  if (!(*limit.order >= kLeastOrder && *limit.order <= kGreatestOrder)) {
    limit.uncertainty = std::max(first, second);
    return limit;
  }
  if (refined == Refined::step && *limit.order > kOrderOfCancelling) {
    limit.values = without_both_orders(values);
    limit.is_extrapolated = true;
    limit.uncertainty = std::max(relative_distance(fine, limit.values), first / kFallOfFirstOrder);
    return limit;
  }
  const double share = 1 / (std::exp2(*limit.order) - 1);
  for (std::size_t i = 0; i < fine.size(); ++i) limit.values[i] += share * second_step[i];
  limit.is_extrapolated = true;
  const double bold = std::exp2(*limit.order) - 1;
  const double careful = std::exp2(std::min(*limit.order, kOrderTrusted)) - 1;
  limit.uncertainty = relative_distance(fine, limit.values) * bold / careful;
  return limit;
}

}  // namespace keyblock::study
