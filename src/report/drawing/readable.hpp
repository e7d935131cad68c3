// Units in which numbers of pictures are short: 159 kPa instead of 1.59e+05 Pa.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "problem/units/measure.hpp"

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

/// Form of values: times `factor`, in `unit`; the exponent of ten that is left is the axis's.
struct Readable {
  double factor = 1;
  std::string unit = {};

  std::string label(std::string_view name) const;  ///< "stress [kPa]"
};

/// Returns the unit of the case if it makes `largest` a number from 0.1 to 1000, or if the case declares too little.
/// Else it is the next below `largest` of mm, m; ms, s; Pa, kPa, MPa, GPa; N/m, kN/m, MN/m; J/m, kJ/m, MJ/m.
Readable readable(const Described& quantity, double largest);

}  // namespace keyblock::report
