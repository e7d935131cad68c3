// Computes logarithms of a plane tensor by divided differences in its principal axes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/elastic_law.hpp"

#include <cmath>

namespace keyblock {
namespace {

// Difference of principal stretches, per mean, below which a series replaces the divided differences.
constexpr double kNearlyEqual = 1e-4;
// Value of ΔE · ΔE below which a step has no direction to correct along (plasticity notes, section 6). The correction
// is of second order in ΔE and there below the round-off of the stress, but its own round-off is divided by ΔE · ΔE.
constexpr double kNoStep = 1e-16;

/// Principal values c1 = m + r ≥ c2 = m - r of C, and f = ½ ln of them by divided differences.
struct Principal {
  double mean = 1;    // m
  double radius = 0;  // r
  double cosine = 1;  // of the angle from x to the first axis
  double sine = 0;
  double first = 0;    // f(c1)
  double second = 0;   // f(c2)
  double slope = 0.5;  // f[c1, c2]

  explicit Principal(const Eigen::Vector3d& green) {
    const double difference = green(0) - green(1);  // (C11 - C22)/2
    mean = 1 + green(0) + green(1);
    radius = std::hypot(difference, green(2));
    const double angle = radius > 0 ? std::atan2(green(2), difference) / 2 : 0;
    cosine = std::cos(angle);
    sine = std::sin(angle);
    first = std::log1p(green(0) + green(1) + radius) / 2;
    second = std::log1p(green(0) + green(1) - radius) / 2;
    const double share = radius / mean;
    slope = share < kNearlyEqual ? (1 + share * share / 3) / (2 * mean) : std::atanh(share) / (2 * radius);
  }

  double greater() const { return mean + radius; }
  double lesser() const { return mean - radius; }

  /// Returns f[c1, c1, c2] and f[c1, c2, c2].
  Eigen::Vector2d curvatures() const {
    const double share = radius / mean;
    if (share < kNearlyEqual) {
      const double both = (-1 - share * share) / (4 * mean * mean);
      const double odd = share / (6 * mean * mean);
      return {both + odd, both - odd};
    }
    return {(1 / (2 * greater()) - slope) / (2 * radius), (slope - 1 / (2 * lesser())) / (2 * radius)};
  }

  /// Returns the matrix that rotates strains (11, 22, 2·12) into the principal axes.
  Eigen::Matrix3d turn() const {
    const double cc = cosine * cosine, ss = sine * sine, cs = cosine * sine;
    Eigen::Matrix3d t;
    t << cc, ss, cs, ss, cc, -cs, -2 * cs, 2 * cs, cc - ss;
    return t;
  }
};

}  // namespace

Eigen::Vector3d log_strain(const Eigen::Vector3d& green) {
  const Principal p(green);
  const double cc = p.cosine * p.cosine, ss = p.sine * p.sine, cs = p.cosine * p.sine;
  return {cc * p.first + ss * p.second, ss * p.first + cc * p.second, 2 * cs * (p.first - p.second)};
}

// In principal axes dε11 = dE11 / c1, dε22 = dE22 / c2, dε12 = 2 f[c1, c2] dE12.
Eigen::Matrix3d log_strain_rate(const Eigen::Vector3d& green) {
  const Principal p(green);
  const Eigen::Matrix3d turn = p.turn();
  const Eigen::Vector3d rate(1 / p.greater(), 1 / p.lesser(), 2 * p.slope);
  // Rotations of strains and of stresses are each other's inverse transpose.
  Principal back = p;
  back.sine = -p.sine;
  return back.turn() * rate.asDiagonal() * turn;
}

// T : D²(½ ln C)[H, H] = 2 Σ T_ij f[c_i, c_k, c_j] H_ik H_kj with H = 2 dE (Daleckii & Krein 1965).
Eigen::Matrix3d log_strain_curvature(const Eigen::Vector3d& green, const Eigen::Vector3d& stress) {
  const Principal p(green);
  const Eigen::Matrix3d turn = p.turn();
  Principal back = p;
  back.sine = -p.sine;
  const Eigen::Vector3d t = back.turn().transpose() * stress;
  const Eigen::Vector2d mixed = p.curvatures();
  Eigen::Matrix3d k = Eigen::Matrix3d::Zero();
  k(0, 0) = -2 * t(0) / (p.greater() * p.greater());
  k(1, 1) = -2 * t(1) / (p.lesser() * p.lesser());
  k(2, 2) = 2 * (t(0) * mixed(0) + t(1) * mixed(1));
  k(0, 2) = k(2, 0) = 4 * t(2) * mixed(0);
  k(1, 2) = k(2, 1) = 4 * t(2) * mixed(1);
  return turn.transpose() * k * turn;
}

Eigen::Vector3d log_step_stress(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& mean) {
  const Eigen::Vector3d at_mean = log_strain_rate((from + to) / 2).transpose() * mean;
  const Eigen::Vector3d change = to - from;
  const Eigen::Vector3d along(change(0), change(1), change(2) / 2);  // ΔE with its tensor shear
  const double size = change.dot(along);
  if (!(size > kNoStep)) return at_mean;
  return at_mean + (mean.dot(log_strain(to) - log_strain(from)) - at_mean.dot(change)) / size * along;
}

// S = Pᵀ T + w/s n, with w = T · Δε - Pᵀ T · ΔE, s = ΔE · n and n = ΔE with the shear of a tensor.
Eigen::Matrix3d log_step_stiffness(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& mean,
                                   const Eigen::Matrix3d& by_end) {
  const Eigen::Vector3d middle = (from + to) / 2;
  const Eigen::Matrix3d rate = log_strain_rate(middle), rate_at_end = log_strain_rate(to);
  const Eigen::Matrix3d stress_by_end = by_end * rate_at_end;
  const Eigen::Matrix3d at_mean = rate.transpose() * stress_by_end + log_strain_curvature(middle, mean) / 2;
  const Eigen::Vector3d change = to - from;
  const Eigen::Vector3d along(change(0), change(1), change(2) / 2);
  const double size = change.dot(along);
  if (!(size > kNoStep)) return at_mean;
  const Eigen::Vector3d logs = log_strain(to) - log_strain(from), stress = rate.transpose() * mean;
  const double share = (mean.dot(logs) - stress.dot(change)) / size;
  const Eigen::RowVector3d work_by_end = logs.transpose() * stress_by_end + mean.transpose() * rate_at_end -
                                         change.transpose() * at_mean - stress.transpose();
  const Eigen::Vector3d tensor(1, 1, 0.5);
  return at_mean + along * (work_by_end - 2 * share * along.transpose()) / size +
         share * Eigen::Matrix3d(tensor.asDiagonal());
}

Eigen::Vector3d ElasticPoint::log_stress_of_step(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                                 double theta) const {
  return log_step_stress(from, to, mean_stress(log_strain(from), log_strain(to), theta));
}

Eigen::Matrix3d ElasticPoint::stiffness(const Eigen::Vector3d& green) const {
  if (law == ElasticLaw::st_venant_kirchhoff) return modulus;
  const Eigen::Matrix3d rate = log_strain_rate(green);
  return rate.transpose() * modulus * rate + log_strain_curvature(green, stress_of_measure(green));
}

// P is taken at the mean strain, which moves by half of the change of the end.
Eigen::Matrix3d ElasticPoint::log_stiffness_of_step(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                                    double theta) const {
  const Eigen::Vector3d mean = (from + to) / 2;
  const Eigen::Matrix3d rate = log_strain_rate(mean);
  const Eigen::Vector3d stress = mean_stress(log_strain(from), log_strain(to), theta);
  return rate.transpose() * modulus * rate + log_strain_curvature(mean, stress) / (2 * theta);
}

}  // namespace keyblock
