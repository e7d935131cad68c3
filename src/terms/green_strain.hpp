// Computes the strain of a displacement gradient, and tensors of vectors of three components.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace keyblock {

/// Returns E of H = ∂u/∂X as (E11, E22, 2 E12), without FᵀF - I, so that no digits are lost for small H.
inline Eigen::Vector3d green_strain(const Eigen::Matrix2d& h) {
  return {h(0, 0) + h.col(0).squaredNorm() / 2, h(1, 1) + h.col(1).squaredNorm() / 2,
          h(0, 1) + h(1, 0) + h.col(0).dot(h.col(1))};
}

/// Returns the 2 × 2 tensor of (xx, yy, xy).
inline Eigen::Matrix2d stress_tensor(const Eigen::Vector3d& stress) {
  Eigen::Matrix2d s;
  s << stress(0), stress(2), stress(2), stress(1);
  return s;
}

}  // namespace keyblock
