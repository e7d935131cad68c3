// What options accept, refused in the words of all other messages.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace keyblock {

/// Refuse what is no such finite number.
CLI::Validator above_zero();
CLI::Validator zero_or_above();

/// Refuses all other words, and asks whether the nearest was meant.
CLI::Validator one_word_of(const std::vector<std::string>& words);

}  // namespace keyblock
