// Sorts runs by cost; a run is on the front if its error is below all before it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/trade/price.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace keyblock::study {
namespace {

bool is_result(const Price& price) {
  return std::isfinite(price.error) && std::isfinite(price.seconds);
}

}  // namespace

std::vector<std::size_t> pareto_front(const std::vector<Price>& prices) {
  std::vector<std::size_t> order(prices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    if (prices[a].seconds != prices[b].seconds) return prices[a].seconds < prices[b].seconds;
    return prices[a].error < prices[b].error;
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (is_result(prices[i]) && (front.empty() || prices[i].error < prices[front.back()].error)) front.push_back(i);
  return front;
}

double over_front(const std::vector<Price>& prices, std::size_t which) {
  const Price& own = prices[which];
  if (!is_result(own)) return std::numeric_limits<double>::infinity();
  double cheapest = own.seconds;
  for (const Price& other : prices)
    if (is_result(other) && other.error <= own.error) cheapest = std::min(cheapest, other.seconds);
  return own.seconds / cheapest;
}

std::optional<std::size_t> choice_for(const std::vector<Price>& prices, const Wish& wish) {
  const auto meets = [&](std::size_t i) {
    return !(wish.budget && prices[i].seconds > *wish.budget) && !(wish.error && prices[i].error > *wish.error);
  };
  std::optional<std::size_t> chosen;
  for (const std::size_t i : pareto_front(prices)) {
    if (!meets(i)) continue;
    chosen = i;
    if (wish.error) break;
  }
  if (!chosen) return chosen;
  const double error = wish.error ? *wish.error : prices[*chosen].error;
  for (std::size_t i = 0; i < *chosen; ++i)
    if (meets(i) && prices[i].error <= error && prices[i].seconds <= kTimingNoise * prices[*chosen].seconds) return i;
  return chosen;
}

}  // namespace keyblock::study
