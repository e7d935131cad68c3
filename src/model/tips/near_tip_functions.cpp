// Uses polar coordinates at the tip; see near_tip_functions.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tips/near_tip_functions.hpp"

#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

struct Polar {
  double r = 0;
  double angle = 0;  // of the direction, -π to π
  double theta = 0;  // continued
};

Polar polar(const TipAxes& tip, double middle, Point x) {
  const double angle = tip.angle_to(x);
  return {distance(tip.at, x), angle, middle + half_turn(angle - middle)};
}

Eigen::RowVector4d angular(double theta) {
  return {std::cos(theta / 2), std::sin(theta / 2), std::cos(1.5 * theta), std::sin(1.5 * theta)};
}

}  // namespace

double TipAxes::angle_to(Point x) const {
  return std::atan2(cross(ahead, x - at), dot(ahead, x - at));
}

double half_turn(double angle) {
  return std::remainder(angle, 2 * std::numbers::pi);
}

Eigen::RowVector4d near_tip_functions(const TipAxes& tip, double middle, Point x) {
  const Polar p = polar(tip, middle, x);
  return std::sqrt(p.r) * angular(p.theta);
}

// ∂/∂r of √r f(θ) is f / 2√r, and 1/r ∂/∂θ of it f' / √r.
NearTipValues near_tip_values(const TipAxes& tip, double middle, Point x) {
  const Polar p = polar(tip, middle, x);
  const double root = std::sqrt(p.r);
  const Eigen::RowVector4d f = angular(p.theta);
  const Eigen::RowVector4d slope{-f(1) / 2, f(0) / 2, -1.5 * f(3), 1.5 * f(2)};
  const double c = std::cos(p.angle), s = std::sin(p.angle);
  const Point out{c * tip.ahead.x - s * tip.ahead.y, c * tip.ahead.y + s * tip.ahead.x};
  NearTipValues v;
  v.values = root * f;
  v.gradients.row(0) = (0.5 * out.x * f - out.y * slope) / root;
  v.gradients.row(1) = (0.5 * out.y * f + out.x * slope) / root;
  return v;
}

}  // namespace keyblock
