// Computes linear elastic moduli of a block material in plane stress and plane strain.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "problem/analysis.hpp"

namespace keyblock {

/// Returns the 3 × 3 modulus of plane stress, (sxx, syy, sxy) = D (ex, ey, gxy): D = E/(1-nu²) [1 nu 0; nu 1 0; 0 0
/// (1-nu)/2] (Timoshenko & Goodier, ch. 2).
Eigen::Matrix3d plane_stress_modulus(const BlockMaterial& material);

/// Returns the 3 × 3 modulus of plane strain, D = E/(1+nu) [(1-nu)/(1-2nu) nu/(1-2nu) 0; .. .. 0; 0 0 1/2] (ibid.).
Eigen::Matrix3d plane_strain_modulus(const BlockMaterial& material);

/// Stretch λ at which a bar under the St. Venant–Kirchhoff law carries the most: F/A = E λ (1 - λ²)/2, largest at 1/√3.
/// Shorter bars carry less and less, and no stress keeps them from being crushed to nothing.
inline constexpr double kSofteningStretch = 0.5773502691896258;

}  // namespace keyblock
