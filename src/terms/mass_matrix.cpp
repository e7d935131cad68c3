// Integrates by area moments, because the displacement operator is linear in position.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/mass_matrix.hpp"

namespace keyblock {

// T = T0 + X Tx + Y Ty about the centroid, where first moments vanish.
UnknownBlock mass_matrix(const Basis& basis, const Moments& moments, double density) {
  const auto& [t0, tx, ty, rotation] = basis;
  const UnknownBlock mixed = tx.transpose() * ty;
  UnknownBlock mass = moments.area * (t0.transpose() * t0);
  mass += moments.xx * (tx.transpose() * tx);
  mass += moments.yy * (ty.transpose() * ty);
  mass += moments.xy * (mixed + mixed.transpose());
  return density * mass;
}

}  // namespace keyblock
