// Finds the axes in the plane along which a symmetric tensor has no shear, and rotates tensors into them and back.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace keyblock {

/// Axes of a tensor (xx, yy, xy, zz) whose xy is the shear, not twice it. Values: the greater in the plane, the lesser,
/// zz.
struct PlaneAxes {
  double cosine = 1, sine = 0;
  Eigen::Vector3d values;

  explicit PlaneAxes(const Eigen::Vector4d& tensor) {
    const double half = (tensor(0) - tensor(1)) / 2;
    const double radius = std::hypot(half, tensor(2));
    const double centre = (tensor(0) + tensor(1)) / 2;
    const double angle = radius > 0 ? std::atan2(tensor(2), half) / 2 : 0;
    cosine = std::cos(angle);
    sine = std::sin(angle);
    values = {centre + radius, centre - radius, tensor(3)};
  }

  /// Returns the tensor with these values along the axes.
  Eigen::Vector4d tensor(const Eigen::Vector3d& v) const {
    const double cc = cosine * cosine, ss = sine * sine, cs = cosine * sine;
    return {cc * v(0) + ss * v(1), ss * v(0) + cc * v(1), cs * (v(0) - v(1)), v(2)};
  }

  /// Returns the matrix that rotates strains (xx, yy, 2xy, zz) into the axes.
  Eigen::Matrix4d turn() const {
    const double cc = cosine * cosine, ss = sine * sine, cs = cosine * sine;
    Eigen::Matrix4d t = Eigen::Matrix4d::Identity();
    t.topLeftCorner<3, 3>() << cc, ss, cs, ss, cc, -cs, -2 * cs, 2 * cs, cc - ss;
    return t;
  }
};

/// Returns ∂stress/∂strain of an isotropic response. `normal` is the derivative of principal stresses by principal
/// strains, in the order of PlaneAxes; `strain` holds the values of `axes`. The rotation of the axes in the plane gives
/// (σ1 - σ2)/(2 (ε1 - ε2)) (de Souza Neto, Perić & Owen 2008, app. A), or its limit for nearly equal strains.
inline Eigen::Matrix4d isotropic_tangent(const PlaneAxes& axes, const Eigen::Vector3d& stress,
                                         const Eigen::Matrix3d& normal) {
  constexpr double kEqual = 1e-7;  // per greatest strain: nearer values count as equal
  const double gap = axes.values(0) - axes.values(1);
  Eigen::Matrix4d local = Eigen::Matrix4d::Zero();
  local.topLeftCorner<2, 2>() = normal.topLeftCorner<2, 2>();
  local.block<2, 1>(0, 3) = normal.block<2, 1>(0, 2);
  local.block<1, 2>(3, 0) = normal.block<1, 2>(2, 0);
  local(3, 3) = normal(2, 2);
  local(2, 2) = gap > kEqual * axes.values.cwiseAbs().maxCoeff()
                    ? (stress(0) - stress(1)) / (2 * gap)
                    : (normal(0, 0) - normal(0, 1) - normal(1, 0) + normal(1, 1)) / 4;
  const Eigen::Matrix4d turn = axes.turn();
  return turn.transpose() * local * turn;
}

}  // namespace keyblock
