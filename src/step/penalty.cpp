// Shi's adaptive penalty: aims at the allowed penetration, falls by at most a factor of three.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/penalty.hpp"

#include <algorithm>

namespace keyblock {
namespace {

constexpr double kFloor = 1e-7;     // added to either estimate (legacy-rules 11.3)
constexpr double kFastestFall = 3;  // the stiffness falls at most by this factor
constexpr double kTooDeep = 2.5;    // penetration over the allowed one that forces a redo
constexpr double kRedoIncrease = 10;

}  // namespace

Misfit misfit(const Contacts& contacts) {
  Misfit greatest;
  for (const Contact& contact : contacts) {
    if (contact.is_open()) continue;
    greatest.opening = std::max(greatest.opening, contact.distance);
    greatest.penetration = std::max(greatest.penetration, -contact.distance);
  }
  return greatest;
}

AdaptedPenalty adapt(double penalty, const Misfit& misfit, double scale, const Settings& settings) {
  if (settings.penalty_control == PenaltyControl::constant) return {penalty, false};
  const double opening = misfit.opening / scale / (2 * settings.allowed_displacement_ratio);
  const double penetration = misfit.penetration / scale / settings.open_close.allowed_penetration;
  const double adapted = std::max({penalty * opening + kFloor, penalty * penetration + kFloor, penalty / kFastestFall});
  const bool redo = penetration > kTooDeep;
  return {redo ? kRedoIncrease * adapted : adapted, redo};
}

}  // namespace keyblock
