// Elastic strain from plastic strain, and back.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/rock_point.hpp"

#include <cmath>

namespace keyblock {

YieldState RockPoint::as_at(const Eigen::Vector3d& strain, const YieldState& state) const {
  YieldState now = state;
  now.elastic = initial - state.plastic;
  now.elastic.head<3>() += strain;
  if (plane == Plane::stress) {
    const double nu = law->poissons_ratio;
    now.elastic(3) = -nu / (1 - nu) * (now.elastic(0) + now.elastic(1));
  }
  return now;
}

Response RockPoint::respond(const Eigen::Vector3d& strain, const YieldState& before) const {
  const double size = std::sqrt(area);
  const YieldState trial = as_at(strain, before);
  if (plane == Plane::stress) return respond_plane_stress(*law, Eigen::Vector3d::Zero(), trial, size);
  return keyblock::respond(*law, Eigen::Vector4d::Zero(), trial, size);
}

Eigen::Vector4d RockPoint::stress(const Eigen::Vector3d& strain, const YieldState& state) const {
  return law->modulus() * as_at(strain, state).elastic;
}

double RockPoint::stored(const Eigen::Vector3d& strain, const YieldState& state) const {
  const Eigen::Vector4d change = as_at(strain, state).elastic - initial;
  return area * change.dot(law->modulus() * (initial + change / 2));
}

double RockPoint::plastic_work(const Eigen::Vector3d& strain, const YieldState& before, const YieldState& after) const {
  return area * stress(strain, after).dot(after.plastic - before.plastic);
}

}  // namespace keyblock
