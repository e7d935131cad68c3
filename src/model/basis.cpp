// Defines the bases, one function each.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/basis.hpp"

namespace keyblock {
namespace {

template <int N>
Point displacement_by(const Basis& basis, const Unknowns& d, Point offset) {
  using Part = Eigen::Map<const Eigen::Matrix<double, 2, N>>;
  const Eigen::Matrix<double, 2, N> t =
      Part(basis.constant.data()) + offset.x * Part(basis.per_x.data()) + offset.y * Part(basis.per_y.data());
  const Eigen::Vector2d u = t * d.head<N>();
  return {u.x(), u.y()};
}

}  // namespace

DisplacementOperator Basis::at(Point offset) const {
  return constant + offset.x * per_x + offset.y * per_y;
}

// Products of known size cost a fraction of those of any size.
Point Basis::displacement(const Unknowns& d, Point offset) const {
  if (unknown_count() == 6) return displacement_by<6>(*this, d, offset);
  if (unknown_count() == 3) return displacement_by<3>(*this, d, offset);
  const Eigen::Vector2d u = at(offset) * d;
  return {u.x(), u.y()};
}

StrainOperator Basis::strain() const {
  StrainOperator strain(3, unknown_count());
  strain.row(0) = per_x.row(0);
  strain.row(1) = per_y.row(1);
  strain.row(2) = per_y.row(0) + per_x.row(1);
  return strain;
}

const Basis& affine_basis() {
  static const Basis basis = [] {
    Basis affine;
    affine.constant = DisplacementOperator::Zero(2, 6);
    affine.per_x = DisplacementOperator::Zero(2, 6);
    affine.per_y = DisplacementOperator::Zero(2, 6);
    affine.constant(0, 0) = 1;
    affine.constant(1, 1) = 1;
    affine.per_y(0, 2) = -1;
    affine.per_x(1, 2) = 1;
    affine.per_x(0, 3) = 1;
    affine.per_y(1, 4) = 1;
    affine.per_y(0, 5) = 0.5;
    affine.per_x(1, 5) = 0.5;
    affine.rotation_unknown = 2;
    return affine;
  }();
  return basis;
}

const Basis& rigid_basis() {
  static const Basis basis{affine_basis().constant.leftCols(3), affine_basis().per_x.leftCols(3),
                           affine_basis().per_y.leftCols(3), 2};
  return basis;
}

const Basis& fixed_basis() {
  static const Basis basis{DisplacementOperator::Zero(2, 0), DisplacementOperator::Zero(2, 0),
                           DisplacementOperator::Zero(2, 0), -1};
  return basis;
}

}  // namespace keyblock
