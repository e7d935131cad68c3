// Rounds of Newton's method with a stop at round-off; see cover_motion.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/bodies/cover_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "step/bodies/linear_static.hpp"

namespace keyblock {
namespace {

constexpr int kMostRounds = 30;
constexpr double kSolved = 1e-13;
// Corrections no longer fall: at round-off where they are this small beside the unknowns; otherwise Newton's method has
// failed.
constexpr double kRoundOff = 1e-9;
// A factor costs some five forces: it is kept, from round to round and from step to step, as long as a round gains a
// digit and a half.
constexpr double kWorstGain = 0.03;

/// Says when rounds end, from the corrections and the residuals they left. Corrections are measured by their
/// displacements, of which unknowns that depend on each other have none.
class Rounds {
 public:
  explicit Rounds(const SparseSystem& mass) : mass_(mass) {}

  bool are_over(double residual, double scale, const Eigen::VectorXd& correction, const Eigen::VectorXd& whole) {
    ++count_;
    residual_ = scale > 0 ? residual / scale : 0;
    const double before = correction_;
    const double size = norm(whole);
    correction_ = norm(correction);
    gain_ = count_ > 1 ? correction_ / before : 0;
    const bool has_stalled = !(correction_ < 0.5 * before) && correction_ <= kRoundOff * size;
    is_solved_ =
        residual <= kSolved * scale || has_stalled || correction_ <= std::numeric_limits<double>::epsilon() * size;
    return is_solved_ || count_ == kMostRounds;
  }
  int count() const { return count_; }
  double residual() const { return residual_; }
  bool is_solved() const { return is_solved_; }
  /// What the last round left of the correction before.
  double gain() const { return gain_; }

 private:
  double norm(const Eigen::VectorXd& x) const { return std::sqrt(std::max(0.0, x.dot(mass_.times(x)))); }

  const SparseSystem& mass_;
  int count_ = 0;
  double residual_ = 0;
  double correction_ = std::numeric_limits<double>::infinity();
  double gain_ = 0;
  bool is_solved_ = false;
};

}  // namespace

ElasticStep cover_step(CoverEquations& equations, const CoverMotion& start, const Eigen::VectorXd& load,
                       const StepRule& rule, double dt) {
  equations.begin(start, load, rule, dt);
  Eigen::VectorXd increment = dt * start.v;
  equations.evaluate(increment);
  Rounds rounds(equations.bodies().mass);
  for (;;) {
    if (!equations.has_factor() || rounds.gain() > kWorstGain) equations.linearise(increment);
    const Eigen::VectorXd next = equations.free_increment();
    const Eigen::VectorXd correction = next - increment;
    increment = next;
    equations.evaluate(increment);
    if (rounds.are_over(equations.residual().norm(), equations.force_scale(), correction, start.q + increment)) break;
  }
  return {equations.end(increment), rounds.count(), rounds.residual(), rounds.is_solved()};
}

CoverMotion rest(const ElasticBodies& bodies) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(bodies.unknown_count());
  return {zero, zero, zero};
}

Eigen::VectorXd acceleration_at(const ElasticBodies& bodies, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                                const Eigen::VectorXd& load) {
  PartFactors factors(bodies.mass, bodies.rigid.functions(), definiteness_of(bodies.continuum.functions));
  factors.factorise(bodies.mass);
  const Eigen::VectorXd force = load - bodies.force(q, bodies.yield.start()) - bodies.mass_damping.times(v);
  return factors.solve(force);
}

CoverEquilibrium cover_equilibrium(const ElasticBodies& bodies, const Eigen::VectorXd& q, const Eigen::VectorXd& load) {
  SparseSystem tangent = bodies.mass;
  PartFactors factors(tangent, bodies.rigid.functions(), definiteness_of(bodies.continuum.functions));
  const YieldStates points = bodies.yield.start();
  const auto residual_at = [&](const Eigen::VectorXd& at) -> Eigen::VectorXd {
    return bodies.force(at, points) - load;
  };
  Eigen::VectorXd at = q;
  Eigen::VectorXd residual = residual_at(at);
  Rounds rounds(bodies.mass);
  for (;;) {
    tangent.clear();
    tangent.add_scaled(1, bodies.ghost);
    tangent.add_scaled(1, bodies.supports);
    bodies.elasticity.add_static_tangent(at, 1, tangent);
    factors.factorise(tangent);
    const Eigen::VectorXd correction = factors.solve(residual);
    at -= correction;
    residual = residual_at(at);
    const double scale = std::max(load.norm(), bodies.supports.times(at).norm());
    if (rounds.are_over(residual.norm(), scale, correction, at)) break;
  }
  return {at, rounds.count(), rounds.residual(), rounds.is_solved()};
}

}  // namespace keyblock
