// Quantities of axes and colour bars, with the unit in which their numbers are short: 159 kPa, not 1.59e+05 Pa.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "problem/units/measure.hpp"
#include "problem/units/readable.hpp"

namespace keyblock::report {

/// A quantity of an axis or a colour bar: its words alone, or a name with what it measures in the units of a case.
struct Described {
  Described(std::string words) : name(std::move(words)) {}
  Described(std::string_view words) : name(words) {}
  Described(const char* words) : name(words) {}
  Described(std::string_view words, const Measure& of, const Units& of_case)
      : name(words), measure(of), units(of_case) {}
  Described() = default;

  std::string name = {};
  Measure measure = measures::kNumber;
  Units units = {};
};

/// Returns the unit in which values of a quantity up to `largest` are short.
inline Scaled readable(const Described& quantity, double largest) {
  return scaled_unit(largest, quantity.measure, quantity.units);
}

}  // namespace keyblock::report
