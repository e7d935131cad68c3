// Declares the limits of input values, with the words of messages; all formats share them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/text/tokens.hpp"

namespace keyblock::formats {

inline constexpr Demand kPositive{[](double v) { return v > 0; }, "greater than 0"};
inline constexpr Demand kNotNegative{[](double v) { return v >= 0; }, "0 or more"};
inline constexpr Demand kShare{[](double v) { return v >= 0 && v <= 1; }, "0 to 1"};
inline constexpr Demand kEdgeNodeRatio{[](double v) { return v >= 0 && v < 1; }, "at least 0 and below 1"};
inline constexpr Demand kFrictionAngle{[](double v) { return v >= 0 && v < 90; }, "at least 0 and below 90 degrees"};
/// Plane stress divides by 1 − ν², plane strain by 1 − 2ν: only the latter excludes 0.5.
inline constexpr Demand kPoissonPlaneStress{[](double v) { return v >= 0 && v <= 0.5; }, "0 to 0.5"};
inline constexpr Demand kPoissonPlaneStrain{[](double v) { return v >= 0 && v < 0.5; },
                                            "at least 0 and below 0.5 in plane strain"};
/// No run could finish more steps than the upper limit.
inline constexpr Demand kStepCount{[](double v) { return v >= 1 && v <= 1e8 && is_whole(v); },
                                   "a whole number from 1 to 100000000"};
inline constexpr Demand kAtLeastOne{[](double v) { return v >= 1 && is_whole(v); }, "a whole number, 1 or more"};

}  // namespace keyblock::formats
