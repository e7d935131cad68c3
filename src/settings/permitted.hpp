// Defines the values that a setting permits.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/limits.hpp"

namespace keyblock {

struct Permitted {
  std::string expected = {};            ///< in words: "a number of at least 0", "one of off, on"
  std::optional<Range> range = {};      ///< of a number
  bool whole = false;                   ///< of numbers: whole ones alone
  std::vector<std::string> words = {};  ///< all of them; empty for numbers and other texts
};

}  // namespace keyblock
