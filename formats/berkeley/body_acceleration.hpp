// Accelerations of the blocks in time, as of an earthquake: a table beside the files of a case.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layout: CSV with a header and the columns `time`, `ax`, `ay`, in any order; others are passed over. Times increase
// from row to row; the acceleration is linear between rows, and before the first and after the last row that of the
// nearest one. Units are those of the input: [T], [L/T²].
#pragma once

#include "formats/format.hpp"
#include "problem/time_curve.hpp"

namespace keyblock::formats {

/// Throws InputError, with the cell, where a column is missing, a value is no number, times do not increase, or there
/// is no row.
TimeCurve read_body_acceleration(const Source& source);

}  // namespace keyblock::formats
