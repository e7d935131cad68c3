// Defines the measures that all pictures of runs share.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace keyblock::report {

inline constexpr double kPageWidth = 900;  ///< in the unit of the picture
inline constexpr double kMargin = 30;
inline constexpr double kTitleHeight = 44;
inline constexpr double kRoom = kPageWidth - 2 * kMargin;

}  // namespace keyblock::report
