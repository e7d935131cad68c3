// Checks the values of options, with the wording of all other messages.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace keyblock {

/// Rejects values that are not such finite numbers.
CLI::Validator above_zero();
CLI::Validator zero_or_above();

/// Rejects all other words, and suggests the nearest.
CLI::Validator one_word_of(const std::vector<std::string>& words);

}  // namespace keyblock
