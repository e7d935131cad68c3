// Tables and pictures name units by letters (L, M, T, F); here they get the names that a case declares.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/run_choices.hpp"

namespace keyblock {

/// "N", "kN", "kPa", or spelt out: the unit of force, and of stress, of a case; empty where it does not declare what
/// that takes.
std::string force_unit(const Units& units);
std::string stress_unit(const Units& units);

/// `[L]`, `[T]`, `[F]`, `[F L]`, `[F/L²]` with the units of the case, and the length of a scale bar; what it does not
/// declare stays. Of a table only the first line is changed.
std::string table_in_units(std::string text, const Units& units);
std::string picture_in_units(std::string text, const Units& units);

}  // namespace keyblock
