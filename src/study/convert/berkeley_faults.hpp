// Reproduces the reading faults of the Berkeley program, for users who need its results.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/case.hpp"

namespace keyblock::study {

/// Returns the content as the Berkeley program reads it (legacy-formats 2.1, 2.3.1, 2.6, 4; legacy-rules 16.1). Each
/// fault is a warning:
///   dda-geometry           the first material line is lost; bolts are not read, so that their numbers become fixed
///                          lines and points
///   dda-analysis-berkeley  the initial velocity is that of the numbers of the stress gradient, which stays
///   ddaml                  lines of Boundlist are dropped; Ivelocity is initial velocity and stress gradient, Istrain
///                          has no effect
/// The program does not read files of other formats: their content stays. Throws InputError where the program would
/// continue with arbitrary memory contents: bolts without 7 numbers, or a carry-over not written as a whole number.
formats::Reading as_berkeley_reads(const formats::FileReading& file);

}  // namespace keyblock::study
