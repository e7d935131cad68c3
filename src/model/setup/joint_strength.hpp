// Scales the strength of all joints, for strength reduction.
// Theory: docs/theory/11-strength-reduction.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/model.hpp"

namespace keyblock {

/// Multiplies tan φ, cohesion and tensile strength of every joint material by `factor` ≥ 0. The factor 1 changes no
/// bit.
Model with_joint_strength(Model model, double factor);

}  // namespace keyblock
