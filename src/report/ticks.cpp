// Ticks are whole multiples of the interval, computed as such so that no rounding creeps from tick to tick.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace keyblock::report {
namespace {

/// Labels of more than five figures before the point, or of more than two zeros behind it, get a power of
/// ten.
int label_exponent(double largest) {
  if (largest < 1e5 && largest >= 1e-2) return 0;
  return 3 * static_cast<int>(std::floor(std::log10(largest) / 3));
}

/// Decimals that tell neighbouring ticks apart.
int decimals(double interval) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10(interval) - 1e-9)), 0, 15);
}

/// An interval on which numbers of this size can still be told apart.
double safe_span(double low, double high) {
  const double size = std::max(std::abs(low), std::abs(high));
  if (high - low > 1e-12 * size) return high - low;
  return size > 0 ? 0.1 * size : 1;
}

}  // namespace

double round_down(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (double factor : {5.0, 2.0})
    if (factor * power <= value * (1 + 1e-12)) return factor * power;
  return power;
}

Axis make_axis(double low, double high, int wanted) {
  const double span = safe_span(low, high);
  double interval = round_down(span / wanted);
  if (span / interval > 1.6 * wanted) interval = round_down(2.5 * interval);
  const double first = std::floor(low / interval + 1e-9);
  const double last = std::max(std::ceil(high / interval - 1e-9), first + 1);
  Axis axis;
  axis.exponent = label_exponent(std::max(std::abs(first), std::abs(last)) * interval);
  const double unit = std::pow(10, axis.exponent);
  for (double k = first; k <= last; ++k) {
    const double tick = k * interval;
    axis.ticks.push_back(tick);
    axis.labels.push_back(k == 0 ? "0" : fmt::format("{:.{}f}", tick / unit, decimals(interval / unit)));
  }
  return axis;
}

}  // namespace keyblock::report
