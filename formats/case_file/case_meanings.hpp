// Declares the meanings of the keys of a case file, and the quantities of its numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "problem/units/measure.hpp"

namespace keyblock::formats {

/// Key and its meaning with the unit: L length, M mass, T time, F force, all per unit thickness. If the meaning depends
/// on it, the key above stands first ("units.length"; "case" is the whole file).
struct CaseMeaning {
  std::string_view key;
  std::string_view meaning;
  std::optional<Measure> measure = {};  ///< of a number; a number of the schema without one fails a test
};

std::span<const CaseMeaning> case_meanings();

}  // namespace keyblock::formats
