// The displacement of a point of an element from the element's few unknowns: u(x) = T(x) d.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "geometry/point.hpp"
#include "system/block_matrix.hpp"

namespace keyblock {

/// The most unknowns an element may have: they are one block of the system.
inline constexpr int kMostUnknowns = kMostBlockRows;

/// n unknowns, n × n coupling of two elements, 2 × n and 3 × n operators; n ≤ kMostUnknowns, never on the
/// heap.
using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMostUnknowns, 1>;
using UnknownBlock =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMostUnknowns, kMostUnknowns>;
using DisplacementOperator = Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::ColMajor, 2, kMostUnknowns>;
using StrainOperator = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, kMostUnknowns>;

/// A basis linear in the coordinates (X, Y) from the element's centroid: T = constant + X per_x + Y per_y.
/// Loads, mass, stiffness and contact are written through these three operators alone, whatever the basis.
struct Basis {
  DisplacementOperator constant;
  DisplacementOperator per_x;
  DisplacementOperator per_y;
  int rotation_unknown = -1;  ///< which unknown is the rotation (rad), -1 if none is

  int unknown_count() const { return static_cast<int>(constant.cols()); }

  /// T at `offset` from the centroid, 2 × n.
  DisplacementOperator at(Point offset) const;

  /// u = T d at `offset` from the centroid.
  Point displacement(const Unknowns& d, Point offset) const;

  /// Tᵀ F, n × 2: what each of two forces (columns of F, 2 × 2) at `offset` from the centroid is on the unknowns. `N`:
  /// how many unknowns there are, where that is known.
  template <int N = Eigen::Dynamic>
  auto generalised_forces(Point offset, const Eigen::Matrix2d& pair) const {
    constexpr int kMost = N == Eigen::Dynamic ? kMostUnknowns : N;
    using Operator = Eigen::Matrix<double, 2, N, Eigen::ColMajor, 2, kMost>;
    const auto part = [](const DisplacementOperator& all) {
      return Eigen::Map<const Operator>(all.data(), 2, all.cols());
    };
    const Operator t = part(constant) + offset.x * part(per_x) + offset.y * part(per_y);
    return Eigen::Matrix<double, N, 2, Eigen::ColMajor, kMost, 2>(t.transpose() * pair);
  }

  /// B, 3 × n: engineering strain (ex, ey, gxy) = B d.
  StrainOperator strain() const;
};

/// Shi's block: u, v, r, ex, ey, gxy about the centroid (Shi 1988, eq. of complete first-order displacement):
///     T = [1 0 -Y X 0 Y/2; 0 1 X 0 Y X/2].
const Basis& affine_basis();

/// A body that moves without deforming: u, v, r, the first three columns of the affine basis.
const Basis& rigid_basis();

/// A body that does not move: no unknowns.
const Basis& fixed_basis();

}  // namespace keyblock
