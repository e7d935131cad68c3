// Formats a number with a unit of a readable size: 0.775 mm instead of 0.000775 m.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/units/measure.hpp"

namespace keyblock {

/// Returns `value`, given in the units of the case, with three digits and its unit: "-270 kPa". Lengths, stresses and
/// times take the prefix that fits. A unit that the case does not declare is left out.
std::string readable(double value, const Measure& measure, const Units& units);

}  // namespace keyblock
