// Puts the known parts of a rule on the right side and inverts the rest.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/bodies/step_equations.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <utility>

namespace keyblock {
namespace {

Unknowns known(const StepSum& sum, const BlockMotion& start) {
  return sum.velocity * start.v + sum.acceleration * start.a;
}

}  // namespace

StepInverses inverses_of(const UnknownBlock& a, const Body& body, const StepRule& rule, bool is_symmetric) {
  const auto put_inverse = [is_symmetric](const UnknownBlock& of, UnknownBlock& inverse) {
    if (!is_symmetric) {
      inverse = of.partialPivLu().inverse();
      return inverse.allFinite() && (inverse.diagonal().array() > 0).all();
    }
    const auto put = [&](const auto& whole) {
      const auto factor = whole.llt();
      inverse = factor.solve(std::decay_t<decltype(whole)>::Identity(whole.rows(), whole.cols()));
      return factor.info() == Eigen::Success;
    };
    if (of.rows() != kMostUnknowns) return put(of);
    return put(Eigen::Matrix<double, kMostUnknowns, kMostUnknowns>(of));  // of a size that the compiler knows
  };
  StepInverses made;
  const double missing =
      std::max(0.0, rule.judging_inertia * body.slowest_frequency * body.slowest_frequency - rule.inertia.increment);
  made.are_definite = put_inverse(a, made.inverse);
  if (missing > 0)
    put_inverse(a + missing * body.mass, made.judging);
  else
    made.judging = made.inverse;
  return made;
}

StepEquations step_equations(const Body& body, const BlockMotion& start, const Unknowns& load, const StepRule& rule) {
  const double inertia = rule.inertia.increment + rule.damping.increment * body.mass_damping;
  const double stiffness = rule.strain.increment + rule.strain_rate.increment * body.stiffness_damping;
  const UnknownBlock a = body.sum_of(inertia, stiffness);
  const Unknowns strained =
      start.q + known(rule.strain, start) + body.stiffness_damping * known(rule.strain_rate, start);
  const Unknowns r = load + body.initial_stress - body.elastic_force(strained) -
                     body.mass * (known(rule.inertia, start) + body.mass_damping * known(rule.damping, start));
  StepEquations equations{a, {}, {}, {}, known(rule.end_velocity, start), known(rule.end_acceleration, start)};
  if (a.rows() > 0) {
    StepInverses inverses = inverses_of(a, body, rule);
    equations.inverse = std::move(inverses.inverse);
    equations.judging = std::move(inverses.judging);
  }
  equations.free = equations.inverse * r;
  return equations;
}

}  // namespace keyblock
