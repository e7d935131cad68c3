// Checks whether a fit has the shape of the measurements.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/error.hpp"
#include "study/fit/measured.hpp"

namespace keyblock::study {

/// Returns `poor_fit` if R² is below 0.9, or if neighbouring points lie on one side of the fit. The latter means a
/// tenth of all points, by more than 5 % of the greatest value on average. Errors and intervals are then meaningless.
Warnings doubts_of_fit(const MeasuredPairs& measured, const Agreement& agreement);

/// Returns `softening` if stress (compression positive) falls after its peak by more than a tenth of it. Peak and end
/// are means of three points. The fitted law has a plateau there.
Warnings doubts_of_curve(const MeasuredPairs& measured);

}  // namespace keyblock::study
