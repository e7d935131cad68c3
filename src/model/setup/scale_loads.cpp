// Wraps functions of position to scale them; see scale_loads.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setup/scale_loads.hpp"

#include <utility>

namespace keyblock {

Continuum with_loads(Continuum continuum, double factor) {
  if (factor == 1) return continuum;
  const auto times = [factor](auto of) {
    return [factor, of = std::move(of)](auto... at) { return factor * of(at...); };
  };
  for (BlockMaterial& material : continuum.materials) {
    material.unit_weight *= factor;
    material.horizontal_force *= factor;
  }
  if (continuum.body_force) continuum.body_force = times(continuum.body_force);
  for (Traction& part : continuum.tractions) part.force = times(part.force);
  for (ChangingTraction& part : continuum.changing_tractions) part.force = times(part.force);
  for (FollowingPressure& part : continuum.pressures) part.pressure = times(part.pressure);
  for (PrescribedDisplacement& part : continuum.prescribed) part.value = times(part.value);
  for (PointForce& force : continuum.point_forces) force.force = factor * force.force;
  return continuum;
}

}  // namespace keyblock
