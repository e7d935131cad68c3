// Computes the modulus of a block material in the plane of the run, and its initial stress.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "problem/analysis.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Returns the 3 × 3 modulus of plane stress or plane strain, (sxx, syy, sxy) = D (ex, ey, gxy).
Eigen::Matrix3d modulus_of(const BlockMaterial& material, Plane plane);

/// Returns the components in the plane: xx, yy, xy.
Eigen::Vector3d in_plane(const Stress& stress);

/// Returns the change of szz per change of sxx + syy: ν under plane strain (ezz = 0), 0 under plane stress (Timoshenko
/// & Goodier, ch. 2). It holds also for second Piola–Kirchhoff stresses under the St. Venant–Kirchhoff law.
double share_across(const BlockMaterial& material, Plane plane);

/// Returns `in_plane` with the szz of that law, counted from `start`.
Stress with_across(const Eigen::Vector3d& in_plane, const Stress& start, double share_across);

/// Returns the initial stress of the material at the height `y`, with `gradient` as its change per y in the plane. The
/// stress across it is that of the material, or else follows the law from zero; it is 0 under plane stress.
Stress start_stress(const BlockMaterial& material, const Stress& gradient, double y, Plane plane);

}  // namespace keyblock
