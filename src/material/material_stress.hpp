// What a block material says of stress: how much a strain makes in the plane of the run, and what there is at the
// start.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "problem/analysis.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// 3 × 3 modulus of plane stress or plane strain, (sxx, syy, sxy) = D (ex, ey, gxy).
Eigen::Matrix3d modulus_of(const BlockMaterial& material, Plane plane);

/// The start stress of the material at the height `y`, with `gradient` as its change per y.
Stress start_stress(const BlockMaterial& material, const Stress& gradient, double y);

}  // namespace keyblock
