// The least energy that a scene is measured by: blocks that stand store next to nothing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "result/frame.hpp"
#include "run/prepare.hpp"

namespace keyblock {

// Blocks that stand store next to nothing but the strain of their weight, the less the stiffer they are, and a share of
// that says nothing of their motion: energies are held against no less than the work of all weights over this share of
// the size of the mean block.
inline constexpr double kWayOfWeight = 1e-4;

/// Work of the weight of all free elements of `first` over `kWayOfWeight` of the size of the mean block, per unit
/// thickness [energy].
double work_of_weight(const Prepared& prepared, const Frame& first);

}  // namespace keyblock
