// Evaluates closed forms; see near_tip_field.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/near_tip_field.hpp"

#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

/// u / (√(r/2π) / 2μ) and its derivative by θ, for each mode.
struct Angular {
  Eigen::Vector2d value;
  Eigen::Vector2d slope;
};

Angular opening(double kappa, double theta) {
  const double c = std::cos(theta / 2), s = std::sin(theta / 2);
  // ux = c (κ - 1 + 2 s²), uy = s (κ + 1 - 2 c²)
  return {{c * (kappa - 1 + 2 * s * s), s * (kappa + 1 - 2 * c * c)},
          {-s / 2 * (kappa - 1 + 2 * s * s) + 2 * c * c * s, c / 2 * (kappa + 1 - 2 * c * c) + 2 * s * s * c}};
}

Angular sliding(double kappa, double theta) {
  const double c = std::cos(theta / 2), s = std::sin(theta / 2);
  // ux = s (κ + 1 + 2 c²), uy = -c (κ - 1 - 2 s²)
  return {{s * (kappa + 1 + 2 * c * c), -c * (kappa - 1 - 2 * s * s)},
          {c / 2 * (kappa + 1 + 2 * c * c) - 2 * s * s * c, s / 2 * (kappa - 1 - 2 * s * s) + 2 * c * c * s}};
}

Angular angular(const PlaneElasticity& rock, const StressIntensity& k, double theta) {
  const double kappa = rock.kolosov();
  const Angular one = opening(kappa, theta), two = sliding(kappa, theta);
  return {k.mode_1 * one.value + k.mode_2 * two.value, k.mode_1 * one.slope + k.mode_2 * two.slope};
}

}  // namespace

double PlaneElasticity::effective_modulus() const {
  return is_plane_strain ? youngs_modulus / (1 - poissons_ratio * poissons_ratio) : youngs_modulus;
}

double PlaneElasticity::kolosov() const {
  return is_plane_strain ? 3 - 4 * poissons_ratio : (3 - poissons_ratio) / (1 + poissons_ratio);
}

bool faces_overlap(const StressIntensity& k) {
  return k.mode_1 < -kNoiseOfFactors * std::hypot(k.mode_1, k.mode_2);
}

double energy_release(const PlaneElasticity& rock, const StressIntensity& k) {
  return (k.mode_1 * k.mode_1 + k.mode_2 * k.mode_2) / rock.effective_modulus();
}

Eigen::Matrix2d near_tip_gradient(const PlaneElasticity& rock, const StressIntensity& k, double r, double theta) {
  const Angular g = angular(rock, k, theta);
  const double scale = 1 / (2 * rock.shear_modulus() * std::sqrt(2 * std::numbers::pi * r));
  const double c = std::cos(theta), s = std::sin(theta);
  Eigen::Matrix2d gradient;
  gradient.col(0) = scale * (0.5 * c * g.value - s * g.slope);
  gradient.col(1) = scale * (0.5 * s * g.value + c * g.slope);
  return gradient;
}

Eigen::Vector3d near_tip_stress(const StressIntensity& k, double r, double theta) {
  const double c = std::cos(theta / 2), s = std::sin(theta / 2);
  const double c3 = std::cos(1.5 * theta), s3 = std::sin(1.5 * theta);
  const double scale = 1 / std::sqrt(2 * std::numbers::pi * r);
  const Eigen::Vector3d one{c * (1 - s * s3), c * (1 + s * s3), s * c * c3};
  const Eigen::Vector3d two{-s * (2 + c * c3), s * c * c3, c * (1 - s * s3)};
  return scale * (k.mode_1 * one + k.mode_2 * two);
}

}  // namespace keyblock
