// What the Berkeley program makes of its files where it reads them wrongly, for those who want its results back.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/case.hpp"

namespace keyblock::study {

/// The content as the Berkeley program takes it (legacy-formats 2.1, 2.3.1, 2.6, 4; legacy-rules 16.1), each fault a
/// warning:
///   dda-geometry           the first material line is lost; bolts are not read, so that their numbers become fixed
///                          lines and points
///   dda-analysis-berkeley  the initial velocity is that of the numbers of the stress gradient, which stays
///   ddaml                  lines of Boundlist are dropped; Ivelocity is initial velocity and stress gradient, Istrain
///                          has no effect
/// Files of other formats it does not read: their content stays. Throws InputError where the program goes on with what
/// is by chance in its memory: bolts not of 7 numbers, a carry-over that is not spelled as a whole number.
formats::Reading as_berkeley_reads(const formats::FileReading& file);

}  // namespace keyblock::study
