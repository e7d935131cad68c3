// Ticks are whole multiples of the interval, computed as such so that no rounding creeps from tick to tick.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/ticks.hpp"

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

/// Returns the decimals that distinguish neighbouring ticks.
int decimals(double interval) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10(interval) - 1e-9)), 0, 15);
}

/// Below it a fifth of a span, or a thousandth of its unit, is no full number any more: such values are drawn as 0.
constexpr double kLeastSpan = 1e-290;

/// Returns an interval on which numbers of this size can still be distinguished.
double safe_span(double low, double high) {
  const double size = std::max(std::abs(low), std::abs(high));
  if (size < kLeastSpan) return 1;
  return std::max(high - low > 1e-12 * size ? high - low : 0.1 * size, kLeastSpan);
}

}  // namespace

double round_down(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (double factor : {5.0, 2.0})
    if (factor * power <= value * (1 + 1e-12)) return factor * power;
  return power;
}

std::string with_exponent(const std::string& label, int exponent) {
  return exponent == 0 ? label : fmt::format("{}  × 1e{}", label, exponent);
}

Axis make_axis(double low, double high, int wanted) {
  low = std::clamp(low, -kGreatestDrawn, kGreatestDrawn);
  high = std::clamp(high, -kGreatestDrawn, kGreatestDrawn);
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

Axis make_log_axis(double low, double high) {
  const int first = static_cast<int>(std::floor(std::log10(low) + 1e-9));
  const int last = std::max(static_cast<int>(std::ceil(std::log10(high) - 1e-9)), first + 1);
  const int every = (last - first + 9) / 10;
  Axis axis;
  if (last - first < 3) {
    for (int decade = first; decade < last; ++decade)
      for (const int digit : {1, 2, 5}) {
        axis.ticks.push_back(decade + std::log10(digit));
        axis.labels.push_back(fmt::format("{:g}", digit * std::pow(10, decade)));
      }
    axis.ticks.push_back(last);
    axis.labels.push_back(fmt::format("{:g}", std::pow(10, last)));
    // No further than the data: a tick at or below the least, one at or above the greatest.
    while (axis.ticks.size() > 2 && axis.ticks[1] <= std::log10(low) + 1e-9) {
      axis.ticks.erase(axis.ticks.begin());
      axis.labels.erase(axis.labels.begin());
    }
    while (axis.ticks.size() > 2 && axis.ticks[axis.ticks.size() - 2] >= std::log10(high) - 1e-9) {
      axis.ticks.pop_back();
      axis.labels.pop_back();
    }
    return axis;
  }
  for (int decade = first; decade < last + every; decade += every) {
    axis.ticks.push_back(decade);
    axis.labels.push_back(fmt::format("1e{}", decade));
  }
  return axis;
}

}  // namespace keyblock::report
