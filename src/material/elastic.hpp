// Linear elastic moduli of a block material in plane stress and plane strain.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "problem/analysis.hpp"

namespace keyblock {

/// 3 × 3 modulus of plane stress, (sxx, syy, sxy) = D (ex, ey, gxy):
/// D = E/(1-nu²) [1 nu 0; nu 1 0; 0 0 (1-nu)/2] (Timoshenko & Goodier, ch. 2).
Eigen::Matrix3d plane_stress_modulus(const BlockMaterial& material);

/// 3 × 3 modulus of plane strain, D = E/(1+nu) [(1-nu)/(1-2nu) nu/(1-2nu) 0; .. .. 0; 0 0 1/2] (ibid.).
Eigen::Matrix3d plane_strain_modulus(const BlockMaterial& material);

/// Under the law of St. Venant and Kirchhoff a bar pressed along its axis bears F/A = E λ (1 - λ²)/2 at the stretch λ,
/// the most at 1/√3; shorter, it bears less and less, and nothing keeps it from being crushed to nothing.
inline constexpr double kSofteningStretch = 0.5773502691896258;

}  // namespace keyblock
