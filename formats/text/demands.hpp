// Declares the limits of input values, with the words of messages; all formats share them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/text/tokens.hpp"

namespace keyblock::formats {

inline constexpr Demand kPositive{{0, true}, "greater than 0"};
inline constexpr Demand kNotNegative{{0}, "0 or more"};
inline constexpr Demand kShare{{0, false, 1}, "0 to 1"};
inline constexpr Demand kEdgeNodeRatio{{0, false, 1, true}, "at least 0 and below 1"};
inline constexpr Demand kFrictionAngle{{0, false, 90, true}, "at least 0 and below 90 degrees"};
/// Plane stress divides by 1 − ν², plane strain by 1 − 2ν: only the latter excludes 0.5.
inline constexpr Demand kPoissonPlaneStress{{0, false, 0.5}, "0 to 0.5"};
inline constexpr Demand kPoissonPlaneStrain{{0, false, 0.5, true}, "at least 0 and below 0.5 in plane strain"};
/// No run could finish more steps than the upper limit.
inline constexpr Demand kStepCount{{1, false, 1e8}, "a whole number from 1 to 100000000", true};
inline constexpr Demand kAtLeastOne{{1}, "a whole number, 1 or more", true};

}  // namespace keyblock::formats
