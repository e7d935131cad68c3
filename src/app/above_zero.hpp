// Options that take a number above 0.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace keyblock {

/// Refuse what is no such finite number, in the words of all other messages.
CLI::Validator above_zero();
CLI::Validator zero_or_above();

}  // namespace keyblock
