// Converts between plastic and elastic strain.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/rock_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "material/crack_return.hpp"

namespace keyblock {
namespace {

// Rounding error of the difference of the energies at both ends, per energy; smaller differences are not corrected.
constexpr double kRoundingOfState = 16 * std::numeric_limits<double>::epsilon();

bool is_uniform(const CrackedResponse& r) {
  return r.closed == 0 || r.closed == r.possible;
}

}  // namespace

CrackedResponse RockPoint::cracked(const Eigen::Vector3d& strain, const YieldState& state) const {
  Eigen::Vector4d elastic = initial - state.plastic;
  elastic.head<3>() += strain;
  return cracked_response(law->cracked(), elastic, plane == Plane::stress);
}

YieldState RockPoint::as_at(const Eigen::Vector3d& strain, const YieldState& state) const {
  YieldState now = state;
  now.elastic = initial - state.plastic;
  now.elastic.head<3>() += strain;
  if (plane != Plane::stress) return now;
  if (law->closure) {
    now.elastic = cracked(strain, state).strain;
  } else {
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
  if (law->closure) return cracked(strain, state).stress;
  return law->modulus() * as_at(strain, state).elastic;
}

double RockPoint::stored(const Eigen::Vector3d& strain, const YieldState& state) const {
  if (law->closure) {
    const double at_start = cracked_response(law->cracked(), initial, plane == Plane::stress).stored;
    return area * (cracked(strain, state).stored - at_start);
  }
  const Eigen::Vector4d change = as_at(strain, state).elastic - initial;
  return area * change.dot(law->modulus() * (initial + change / 2));
}

Eigen::Vector4d RockPoint::inelastic(const Eigen::Vector3d& strain, const YieldState& state) const {
  if (!law->closure) return state.plastic;
  const auto cracks = [this](const CrackedResponse& r) {
    return Eigen::Vector4d(r.strain - law->intact_strain(r.stress));
  };
  return state.plastic + cracks(cracked(strain, state)) -
         cracks(cracked_response(law->cracked(), initial, plane == Plane::stress));
}

RockPoint::Missing RockPoint::missing(const Eigen::Vector3d& strain0, const YieldState& before,
                                      const Eigen::Vector3d& strain1, const YieldState& after) const {
  Missing m;
  if (!law->closure) return m;
  m.from = cracked(strain0, before);
  m.to = cracked(strain1, after);
  if (is_uniform(m.from) && is_uniform(m.to) && m.from.closed == m.to.closed) return m;
  m.change = m.to.strain - m.from.strain;
  if (plane == Plane::stress) m.change(3) = 0;
  m.along = m.change;
  m.along(2) /= 2;
  const double work = m.to.stored - m.from.stored - m.change.dot(m.from.stress + m.to.stress) / 2;
  if (std::abs(work) > kRoundingOfState * std::max(m.from.stored, m.to.stored)) m.work = work;
  return m;
}

Eigen::Vector3d RockPoint::missing_stress(const Eigen::Vector3d& strain0, const YieldState& before,
                                          const Eigen::Vector3d& strain1, const YieldState& after) const {
  const Missing m = missing(strain0, before, strain1, after);
  if (m.work == 0) return Eigen::Vector3d::Zero();
  return m.work / m.change.dot(m.along) * m.along.head<3>();
}

Eigen::Matrix3d RockPoint::missing_stiffness(const Eigen::Vector3d& strain0, const YieldState& before,
                                             const Eigen::Vector3d& strain1, const YieldState& after) const {
  const Missing m = missing(strain0, before, strain1, after);
  if (m.work == 0) return Eigen::Matrix3d::Zero();
  const double square = m.change.dot(m.along);
  const Eigen::Vector3d along = m.along.head<3>();
  const Eigen::Vector3d by_end = (m.to.stress - m.from.stress - m.to.tangent * m.change).head<3>() / 2;
  const Eigen::Matrix3d one_sided = along * by_end.transpose() / square;
  const Eigen::Vector3d tensor(1, 1, 0.5);
  return one_sided + m.work / square * Eigen::Matrix3d(tensor.asDiagonal()) -
         2 * m.work / (square * square) * along * along.transpose();
}

double RockPoint::plastic_work(const Eigen::Vector3d& strain, const YieldState& before, const YieldState& after) const {
  return area * stress(strain, after).dot(after.plastic - before.plastic);
}

}  // namespace keyblock
