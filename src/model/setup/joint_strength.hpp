// Joints made weaker or stronger all at once, as strength reduction asks for.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/model.hpp"

namespace keyblock {

/// tan φ, cohesion and tensile strength of every joint material times `factor` ≥ 0. Under the factor 1 nothing changes,
/// to the bit.
Model with_joint_strength(Model model, double factor);

}  // namespace keyblock
