// Computes two products and two sums per body; see ghost_force.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/ghost_force.hpp"

#include <algorithm>

namespace keyblock {

Eigen::VectorXd ghost_force(const SparseSystem& ghost, const std::vector<std::vector<int>>& bodies,
                            const Eigen::VectorXd& d0, const Eigen::VectorXd& d1, double theta) {
  const Eigen::VectorXd mean = (d0 + d1) / 2;
  const Eigen::VectorXd of_mean = ghost.times(mean);
  if (theta == 0.5) return of_mean;
  const Eigen::VectorXd of_change = ghost.times(d1 - d0);
  Eigen::VectorXd force = of_mean + (theta - 0.5) * of_change;
  for (const std::vector<int>& functions : bodies) {
    double moment = 0;
    double square = 0;
    for (const int f : functions) {
      moment += mean(2 * f) * of_change(2 * f + 1) - mean(2 * f + 1) * of_change(2 * f);
      square += mean.segment<2>(2 * f).dot(of_mean.segment<2>(2 * f));
    }
    if (!(square > 0)) continue;
    const double turn =
        std::clamp(moment / square, -1.0, 1.0);  // beyond: quotient of round-off, in a body that is affine
    for (const int f : functions)
      force.segment<2>(2 * f) -= (theta - 0.5) * turn * Eigen::Vector2d(-of_mean(2 * f + 1), of_mean(2 * f));
  }
  return force;
}

}  // namespace keyblock
