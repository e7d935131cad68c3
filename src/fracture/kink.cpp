// Evaluates closed forms and searches for extremes; see kink.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/kink.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/polynomial.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>

namespace keyblock {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kWidest = 80 * kPi / 180;  // limit of the expansion of Amestoy and Leblond
constexpr int kTried = 360;                 // angles between which an extreme is sought
constexpr int kDigits = 40;                 // of a minimum, binary: half of them are significant

double hoop(const StressIntensity& k, double angle) {
  const double half = angle / 2;
  return std::pow(std::cos(half), 2) * (k.mode_1 * std::cos(half) - 3 * k.mode_2 * std::sin(half));
}

Kink by_hoop_stress(const StressIntensity& k) {
  // θ = 2 atan((K_I - √(K_I² + 8 K_II²)) / 4 K_II), without the quotient of two zeros.
  const double root = std::hypot(k.mode_1, std::sqrt(8.0) * k.mode_2);
  const double angle = 2 * std::atan2(-2 * k.mode_2, k.mode_1 + root);
  return {angle, hoop(k, angle)};
}

/// Returns the angle of the local minimum of `f` with the greatest `rank`, among those for which `counts` is true.
std::optional<double> best_minimum(const std::function<double(double)>& f, double widest,
                                   const std::function<bool(double)>& counts,
                                   const std::function<double(double)>& rank) {
  std::optional<double> best;
  const double step = 2 * widest / kTried;
  for (int i = 1; i < kTried; ++i) {
    const double at = -widest + i * step;
    if (f(at) > f(at - step) || f(at) > f(at + step)) continue;
    const double found = boost::math::tools::brent_find_minima(f, at - step, at + step, kDigits).first;
    if (counts(found) && (!best || rank(found) > rank(*best))) best = found;
  }
  return best;
}

/// Returns 16 π μ times the density of strain energy r w (Sih 1974).
double energy_density(double kappa, const StressIntensity& k, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return (1 + c) * (kappa - c) * k.mode_1 * k.mode_1 + 2 * s * (2 * c - kappa + 1) * k.mode_1 * k.mode_2 +
         ((kappa + 1) * (1 - c) + (1 + c) * (3 * c - 1)) * k.mode_2 * k.mode_2;
}

Kink by_strain_energy(const PlaneElasticity& rock, const StressIntensity& k) {
  const double kappa = rock.kolosov();
  const auto density = [&](double angle) { return energy_density(kappa, k, angle); };
  const auto pulls = [&](double angle) { return hoop(k, angle); };
  const std::optional<double> angle = best_minimum(
      density, kPi, [&](double a) { return pulls(a) > 0; }, pulls);
  if (!angle) return {};
  return {*angle, std::sqrt(std::max(0.0, density(*angle) / (2 * (kappa - 1))))};
}

Kink by_energy_release(const StressIntensity& k) {
  const auto loss = [&](double angle) {
    const StressIntensity behind = behind_kink(k, angle);
    return -(behind.mode_1 * behind.mode_1 + behind.mode_2 * behind.mode_2);
  };
  const std::optional<double> angle = best_minimum(
      loss, kWidest, [&](double a) { return behind_kink(k, a).mode_1 > 0; }, [&](double a) { return -loss(a); });
  if (!angle) return {};
  return {*angle, std::sqrt(-loss(*angle))};
}

}  // namespace

StressIntensity behind_kink(const StressIntensity& k, double angle) {
  const double m = angle / kPi;
  const double p2 = kPi * kPi, p3 = p2 * kPi, p4 = p2 * p2, p5 = p4 * kPi, p6 = p4 * p2;
  const auto sum = [&](const auto& coefficients) {
    return boost::math::tools::evaluate_polynomial(coefficients.data(), m * m, coefficients.size());
  };
  const std::array even_11{1.0,
                           -3 * p2 / 8,
                           p2 - 5 * p4 / 128,
                           p2 / 9 - 11 * p4 / 72 + 119 * p6 / 15360,
                           5.07790,
                           -2.88312,
                           -0.0925,
                           2.996,
                           -4.059,
                           1.63,
                           4.1};
  const std::array odd_12{-3 * kPi / 2,
                          10 * kPi / 3 + p3 / 16,
                          -2 * kPi - 133 * p3 / 180 + 59 * p5 / 1280,
                          12.313906,
                          -7.32433,
                          1.5793,
                          4.0216,
                          -6.915,
                          4.21,
                          4.56};
  const std::array odd_21{kPi / 2,
                          -(4 * kPi / 3 + p3 / 48),
                          -2 * kPi / 3 + 13 * p3 / 30 - 59 * p5 / 3840,
                          -6.176023,
                          4.44112,
                          -1.5340,
                          -2.0700,
                          4.684,
                          -3.95,
                          -1.32};
  const std::array even_22{1.0,
                           -(4 + 3 * p2 / 8),
                           8.0 / 3 + 29 * p2 / 18 - 5 * p4 / 128,
                           -32.0 / 15 - 4 * p2 / 9 - 1159 * p4 / 7200 + 119 * p6 / 15360,
                           10.58254,
                           -4.78511,
                           -1.8804,
                           7.280,
                           -7.591,
                           0.25,
                           12.5};
  const double f11 = sum(even_11), f12 = m * sum(odd_12);
  const double f21 = m * sum(odd_21), f22 = sum(even_22);
  return {f11 * k.mode_1 + f12 * k.mode_2, f21 * k.mode_1 + f22 * k.mode_2};
}

double equivalent_of(const Kink& by_criterion, const Toughness& toughness, const StressIntensity& k) {
  if (!toughness.mode_2 || by_criterion.equivalent == 0) return by_criterion.equivalent;
  return std::hypot(std::max(k.mode_1, 0.0), k.mode_2 * toughness.mode_1 / *toughness.mode_2);
}

Kink kink(GrowthCriterion criterion, const PlaneElasticity& rock, const StressIntensity& k) {
  const StressIntensity open{std::max(k.mode_1, 0.0), k.mode_2};
  const double size = std::hypot(open.mode_1, open.mode_2);
  if (!(size > 0) || !std::isfinite(size)) return {};
  if (size <= kNoiseOfFactors * -k.mode_1) return {};  // faces are pressed together; the rest is noise
  const StressIntensity unit{open.mode_1 / size, open.mode_2 / size};
  Kink found;
  switch (criterion) {
    case GrowthCriterion::hoop_stress:
      found = by_hoop_stress(unit);
      break;
    case GrowthCriterion::strain_energy:
      found = by_strain_energy(rock, unit);
      break;
    case GrowthCriterion::energy_release:
      found = by_energy_release(unit);
      break;
  }
  return {found.angle, size * found.equivalent};
}

}  // namespace keyblock
