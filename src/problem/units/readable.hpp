// Formats a number with a unit of a readable size: 0.775 mm instead of 0.000775 m.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "problem/units/measure.hpp"

namespace keyblock {

/// Form of values: times `factor`, in `unit`.
struct Scaled {
  double factor = 1;
  std::string unit = {};

  std::string label(std::string_view name) const;  ///< "stress [kPa]"
};

/// Returns the unit in which values up to `largest`, in the units of the case, are short. Lengths, velocities, times,
/// stresses, forces and energies take the prefix that fits; others keep the unit of the case.
Scaled scaled_unit(double largest, const Measure& measure, const Units& units);

/// Returns `value`, given in the units of the case, with three digits and its unit: "-270 kPa". A unit that the case
/// does not declare is left out.
std::string readable(double value, const Measure& measure, const Units& units);

}  // namespace keyblock
