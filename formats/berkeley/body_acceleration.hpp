// Reads accelerations of the blocks over time, such as those of an earthquake: a table next to the files of a case.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layout: CSV with a header and the columns `time`, `ax`, `ay`, in any order; others are ignored. Times increase from
// row to row. The acceleration is linear between rows; before the first and after the last row it is constant. Headings
// may name units, `time [ms]`, `ax [g]` (standard gravity); other numbers have the units of the case: [T], [L/T²].
#pragma once

#include "formats/format.hpp"
#include "problem/run_choices.hpp"
#include "problem/time_curve.hpp"

namespace keyblock::formats {

/// Returns the table in the units of the case. Throws InputError, with the cell, if a column is missing, a value is not
/// a number, times do not increase, or there is no row. A heading with a wrong unit is refused, and one with any unit
/// if the case declares none.
TimeCurve read_body_acceleration(const Source& source, const Units& units);

}  // namespace keyblock::formats
