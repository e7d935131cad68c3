// Rounds of Newton's method with a stop at round-off; see cover_motion.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/cover_motion.hpp"

#include <algorithm>
#include <limits>

#include "step/linear_static.hpp"

namespace keyblock {
namespace {

constexpr int kMostRounds = 30;
constexpr double kSolved = 1e-12;
// Corrections no longer fall: at round-off where they are this small beside the unknowns; otherwise Newton's method has failed.
constexpr double kRoundOff = 1e-9;

/// Says when rounds end, from the corrections and the residuals they left.
class Rounds {
 public:
  /// `size`: of what is corrected.
  bool are_over(double residual, double scale, double correction, double size) {
    ++count_;
    residual_ = scale > 0 ? residual / scale : 0;
    const bool has_stalled = !(correction < 0.5 * correction_) && correction <= kRoundOff * size;
    is_solved_ =
        residual <= kSolved * scale || correction <= std::numeric_limits<double>::epsilon() * size || has_stalled;
    correction_ = correction;
    return is_solved_ || count_ == kMostRounds;
  }
  int count() const { return count_; }
  double residual() const { return residual_; }
  bool is_solved() const { return is_solved_; }

 private:
  int count_ = 0;
  double residual_ = 0;
  double correction_ = std::numeric_limits<double>::infinity();
  bool is_solved_ = false;
};

}  // namespace

CoverStep cover_step(CoverEquations& equations, const CoverMotion& start, const Eigen::VectorXd& load,
                     const StepRule& rule, double dt) {
  equations.begin(start, load, rule, dt);
  Eigen::VectorXd increment = dt * start.v;
  Rounds rounds;
  for (;;) {
    equations.linearise(increment);
    const Eigen::VectorXd next = equations.free_increment();
    const double correction = (next - increment).norm();
    increment = next;
    equations.evaluate(increment);
    const double size = std::max(increment.norm(), start.q.norm());
    if (rounds.are_over(equations.residual().norm(), equations.force_scale(), correction, size)) break;
  }
  return {equations.end(increment), rounds.count(), rounds.residual(), rounds.is_solved()};
}

CoverMotion rest(const CoverBodies& bodies) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(bodies.unknown_count());
  return {zero, zero, zero};
}

Eigen::VectorXd acceleration_at(const CoverBodies& bodies, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                                const Eigen::VectorXd& load) {
  PartFactors factors(bodies.mass, bodies.rigid.functions(), definiteness_of(bodies.continuum.functions));
  factors.factorise(bodies.mass);
  const Eigen::VectorXd force =
      load - bodies.elasticity.force(q, q, 1) - bodies.constant.times(q) - bodies.damping.mass * bodies.mass.times(v);
  return factors.solve(force);
}

CoverEquilibrium cover_equilibrium(const CoverBodies& bodies, const Eigen::VectorXd& q, const Eigen::VectorXd& load) {
  SparseSystem tangent = bodies.constant;
  PartFactors factors(tangent, bodies.rigid.functions(), definiteness_of(bodies.continuum.functions));
  const auto residual_at = [&](const Eigen::VectorXd& at) -> Eigen::VectorXd {
    return bodies.elasticity.force(at, at, 1) + bodies.constant.times(at) - load;
  };
  Eigen::VectorXd at = q;
  Eigen::VectorXd residual = residual_at(at);
  Rounds rounds;
  for (;;) {
    tangent.clear();
    tangent.add_scaled(1, bodies.constant);
    bodies.elasticity.add_static_tangent(at, 1, tangent);
    factors.factorise(tangent);
    const Eigen::VectorXd correction = factors.solve(residual);
    at -= correction;
    residual = residual_at(at);
    const double scale = std::max(load.norm(), bodies.constant.times(at).norm());
    if (rounds.are_over(residual.norm(), scale, correction.norm(), at.norm())) break;
  }
  return {at, rounds.count(), rounds.residual(), rounds.is_solved()};
}

}  // namespace keyblock
