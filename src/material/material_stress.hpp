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

/// The components in the plane: xx, yy, xy.
Eigen::Vector3d in_plane(const Stress& stress);

/// Change of szz that goes with a change of sxx + syy, over it, where nothing widens across the plane (ezz = 0): ν
/// under plane strain, 0 under plane stress (Timoshenko & Goodier, ch. 2). The law of St. Venant and Kirchhoff says the
/// same of second Piola-Kirchhoff stresses.
double share_across(const BlockMaterial& material, Plane plane);

/// `in_plane` with the szz that it has by that law, from `start` on.
Stress with_across(const Eigen::Vector3d& in_plane, const Stress& start, double share_across);

/// The start stress of the material at the height `y`, with `gradient` as its change per y in the plane. Across it as
/// the material gives it, else as the law has it from nothing; 0 under plane stress.
Stress start_stress(const BlockMaterial& material, const Stress& gradient, double y, Plane plane);

}  // namespace keyblock
