// Integrates by area moments, because the displacement operator is linear in position.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/mass_matrix.hpp"

namespace keyblock {

namespace {

// T = T0 + X Tx + Y Ty about the centroid, where first moments vanish. `N`: number of unknowns, or Eigen::Dynamic.
template <int N>
UnknownBlock mass_of(const Basis& basis, const Moments& moments, double density) {
  constexpr int kMost = N == Eigen::Dynamic ? kMostUnknowns : N;
  using Rows = Eigen::Matrix<double, N, 2, Eigen::ColMajor, kMost, 2>;
  using Square = Eigen::Matrix<double, N, N, Eigen::ColMajor, kMost, kMost>;
  const Rows t0 = basis.constant.transpose();
  const Rows tx = basis.per_x.transpose();
  const Rows ty = basis.per_y.transpose();
  const Square mixed = tx * ty.transpose();
  Square mass = moments.area * (t0 * t0.transpose());
  mass += moments.xx * (tx * tx.transpose());
  mass += moments.yy * (ty * ty.transpose());
  mass += moments.xy * (mixed + mixed.transpose());
  return density * mass;
}

}  // namespace

// Products of known size cost a fraction of those of any size.
UnknownBlock mass_matrix(const Basis& basis, const Moments& moments, double density) {
  if (basis.unknown_count() == 6) return mass_of<6>(basis, moments, density);
  if (basis.unknown_count() == 3) return mass_of<3>(basis, moments, density);
  return mass_of<Eigen::Dynamic>(basis, moments, density);
}

}  // namespace keyblock
