// Computes the displacement of a point of an element from the few unknowns of the element: u(x) = T(x) d.
// Theory: docs/theory/01-kinematics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "geometry/point.hpp"
#include "system/block_matrix.hpp"

namespace keyblock {

/// Largest number of unknowns of an element: they form one block of the linear system.
inline constexpr int kMostUnknowns = kMostBlockRows;

/// Types for n ≤ kMostUnknowns unknowns, never on the heap: n unknowns, the n × n coupling of two elements, and 2 × n
/// and 3 × n operators.
using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMostUnknowns, 1>;
using UnknownBlock =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMostUnknowns, kMostUnknowns>;
using DisplacementOperator = Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::ColMajor, 2, kMostUnknowns>;
using StrainOperator = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, kMostUnknowns>;

/// Basis linear in the coordinates (X, Y) from the element's centroid: T = constant + X per_x + Y per_y. Loads, mass,
/// stiffness and contact use these three operators only, for every basis.
struct Basis {
  DisplacementOperator constant;
  DisplacementOperator per_x;
  DisplacementOperator per_y;
  int rotation_unknown = -1;  ///< index of the rotation [rad]; -1 without one

  int unknown_count() const { return static_cast<int>(constant.cols()); }

  /// Returns T at `offset` from the centroid, 2 × n.
  DisplacementOperator at(Point offset) const;

  /// Returns u = T d at `offset` from the centroid.
  Point displacement(const Unknowns& d, Point offset) const;

  /// Returns Tᵀ F, n × 2: the generalised forces of two forces (columns of F, 2 × 2) at `offset` from the centroid.
  /// `N`: number of unknowns, if known at compile time.
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

  /// Returns B, 3 × n: engineering strain (ex, ey, gxy) = B d.
  StrainOperator strain() const;
};

/// Returns the basis of Shi's block: u, v, r, ex, ey, gxy about the centroid (Shi 1988, complete first-order
/// displacement):
///       T = [1 0 -Y X 0 Y/2; 0 1 X 0 Y X/2].
const Basis& affine_basis();

/// Returns the basis of a rigid body: u, v, r, the first three columns of the affine basis.
const Basis& rigid_basis();

/// Returns the basis of a fixed body, which has no unknowns.
const Basis& fixed_basis();

}  // namespace keyblock
