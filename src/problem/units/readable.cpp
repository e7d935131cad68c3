// Tables of units that differ by a prefix alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/units/readable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "base/words/plain_number.hpp"

namespace keyblock {
namespace {

constexpr int kDigits = 3;
constexpr double kLargest = 1e5;  // from here on a power of ten is written

struct Prefixed {
  std::string_view name;
  double size;
};

/// Units of one kind, the smallest first, and the least number that is written in each but the smallest.
struct Family {
  std::span<const Prefixed> units;
  double least;
};

constexpr std::array<Prefixed, 2> kLengths{{{"mm", 1e-3}, {"m", 1}}};
constexpr std::array<Prefixed, 4> kStresses{{{"Pa", 1}, {"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}}};
constexpr std::array<Prefixed, 2> kTimes{{{"ms", 1e-3}, {"s", 1}}};
constexpr std::array<Family, 3> kFamilies{{{kLengths, 0.1}, {kStresses, 1}, {kTimes, 0.1}}};

std::string digits_of(double value) {
  return std::abs(value) < kLargest ? plain(value, kDigits) : fmt::format("{:.{}g}", value, kDigits);
}

}  // namespace

std::string readable(double value, const Measure& measure, const Units& units) {
  if (!is_declared(measure, units)) return digits_of(value);
  const std::string unit = unit_of(measure, units);
  for (const Family& family : kFamilies) {
    const auto declared = std::ranges::find(family.units, unit, &Prefixed::name);
    if (value == 0 || declared == family.units.end()) continue;
    std::size_t i = family.units.size() - 1;
    while (i > 0 && std::abs(value) * declared->size < family.least * family.units[i].size) --i;
    const auto& [name, size] = family.units[i];
    return fmt::format("{} {}", digits_of(value * declared->size / size), name);
  }
  return unit.empty() ? digits_of(value) : fmt::format("{} {}", digits_of(value), unit);
}

}  // namespace keyblock
