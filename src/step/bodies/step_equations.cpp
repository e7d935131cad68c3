// Moves the known terms of a rule to the right-hand side and inverts the rest.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/bodies/step_equations.hpp"

#include "system/block_factor.hpp"

namespace keyblock {
namespace {

Unknowns known(const StepSum& sum, const BlockMotion& start) {
  return sum.velocity * start.v + sum.acceleration * start.a;
}

}  // namespace

StepEquations step_equations(const Body& body, const BlockMotion& start, const Unknowns& load, const StepRule& rule,
                             KeptInverse& kept) {
  const double inertia = rule.inertia.increment + rule.damping.increment * body.mass_damping;
  const double stiffness = rule.strain.increment + rule.strain_rate.increment * body.stiffness_damping;
  const UnknownBlock a = body.sum_of(inertia, stiffness);
  const Unknowns strained =
      start.q + known(rule.strain, start) + body.stiffness_damping * known(rule.strain_rate, start);
  const Unknowns r = load + body.initial_stress - body.elastic_force(strained) -
                     body.mass * (known(rule.inertia, start) + body.mass_damping * known(rule.damping, start));
  StepEquations equations{a, {}, {}, {}, known(rule.end_velocity, start), known(rule.end_acceleration, start)};
  if (a.rows() > 0) {
    if (kept.inertia != inertia || kept.stiffness != stiffness)
      kept = {inertia, stiffness, inverse_of(a, true).inverse};
    equations.inverse = kept.inverse;
    const double missing =
        rule.judging_inertia * body.slowest_frequency * body.slowest_frequency - rule.inertia.increment;
    if (rule.judging_inertia > 0)
      equations.judging = missing > 0 ? inverse_of(a + missing * body.mass, true).inverse : equations.inverse;
  }
  equations.free = equations.inverse * r;
  return equations;
}

}  // namespace keyblock
