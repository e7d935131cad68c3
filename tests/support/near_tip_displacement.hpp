// Evaluates the displacement near a crack tip (Williams 1957), as an oracle.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "fracture/near_tip_field.hpp"

namespace keyblock::support {

/// Returns (ux, uy), 0 at the tip, in the axes of near_tip_gradient.
inline Eigen::Vector2d near_tip_displacement(const PlaneElasticity& rock, const StressIntensity& k, double r,
                                             double theta) {
  const double kappa = rock.kolosov(), c = std::cos(theta / 2), s = std::sin(theta / 2);
  const Eigen::Vector2d opening{c * (kappa - 1 + 2 * s * s), s * (kappa + 1 - 2 * c * c)};
  const Eigen::Vector2d sliding{s * (kappa + 1 + 2 * c * c), -c * (kappa - 1 - 2 * s * s)};
  return std::sqrt(r / (2 * std::numbers::pi)) / (2 * rock.shear_modulus()) * (k.mode_1 * opening + k.mode_2 * sliding);
}

}  // namespace keyblock::support
