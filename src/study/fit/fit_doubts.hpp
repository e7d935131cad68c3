// Whether what was fitted has the shape of what was measured.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/error.hpp"
#include "study/fit/measured.hpp"

namespace keyblock::study {

/// `poor_fit`: R² below 0.9, or neighbouring points, a tenth of all, that lie on one side of the fit by more than 5 %
/// of the greatest value in the mean; errors and intervals say nothing then.
Warnings doubts_of_fit(const MeasuredPairs& measured, const Agreement& agreement);

/// `softening`: stress (compression positive) that falls after its peak by more than a tenth of it. Peak and end are
/// means of three points. The fitted law has a plateau there.
Warnings doubts_of_curve(const MeasuredPairs& measured);

}  // namespace keyblock::study
