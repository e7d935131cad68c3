// The order of contact-notes 3, scheme F; the clean-up comes before the jump, so that it cannot undo a separation.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/standard_step.hpp"

#include <algorithm>
#include <cmath>

#include "contact/gap.hpp"
#include "step/impact.hpp"
#include "step/ledger.hpp"
#include "step/smooth_solve.hpp"

namespace keyblock {
namespace {

constexpr int kMostHalvings = 2;
// Residual of the contact forces over the largest load on a block: few contacts reach the first, assemblies the second.
constexpr double kForceGoal = 1e-10;
constexpr double kForceAcceptable = 1e-6;
// Where nothing loads the blocks, forces come from momentum alone: the same over momentum / dt.
constexpr double kMomentumGoal = 1e-13;
// Touches that overlapped take part in the jump, and those with a gap below this share of block size: the corners of a flat
// impact meet within round-off.
constexpr double kMeeting = 1e-10;

struct Split {
  Touches smooth;
  Touches impacts;
  std::vector<double> impact_speeds;  ///< normal velocity at the start of the step, negative
};

Split split(const StandardScene& scene, const Motion& start, const Touches& touches, double slow) {
  const ContactRows rows = contact_rows(scene.model, scene.reference, start.q, touches);
  const Eigen::VectorXd speeds = rates(rows, start.v);
  Split parts;
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const double speed = speeds[static_cast<Eigen::Index>(2 * i)];
    if (speed > -slow || start.closed.contains(touches[i])) {
      parts.smooth.push_back(touches[i]);
    } else {
      parts.impacts.push_back(touches[i]);
      parts.impact_speeds.push_back(speed);
    }
  }
  return parts;
}

class Attempt {
 public:
  Attempt(const StandardScene& scene, const Motion& start, double time, double dt)
      : scene_(scene), start_(start), dt_(dt) {
    loads_ = loads_at(scene, start.q, time + dt / 2);
    scales_ = scales_of(scene, loads_, start.v);
    const Touches touches = touches_of(scene, start, scales_, dt);
    step_.touches = static_cast<int>(touches.size());
    parts_ = split(scene, start, touches, slow_speed(scales_, start.v, dt));
    const double goal = kForceGoal * scales_.force + kMomentumGoal * scales_.momentum / dt;
    const ForceTolerance tolerance{goal, std::max(goal, kForceAcceptable * scales_.force)};
    least_force_ = goal;
    smooth_ = smooth_solve(scene, start, loads_, parts_.smooth, tolerance, dt);
  }

  StandardStep run() {
    step_.solves = smooth_.solves;
    step_.residual = scales_.force > 0 ? smooth_.residual / scales_.force : 0;
    step_.converged = smooth_.converged;
    for (std::size_t i : smooth_.undecided) step_.undecided.push_back(parts_.smooth[i]);
    if (!step_.converged) return std::move(step_);
    const Touches closed = closed_touches();
    step_.motion.q = smooth_.q;
    step_.motion.v = smooth_.v;
    if (!scene_.has_springs())
      step_.motion.v = with_closed_at_rest(scene_, smooth_.q, std::move(step_.motion.v), closed);
    const UnknownsTable cleaned = step_.motion.v;
    if (!parts_.impacts.empty()) strike(closed);
    remember();
    if (scene_.settings.ledger == Bookkeeping::on)
      step_.account = account_of(scene_, {start_, loads_, parts_.smooth, smooth_, cleaned, step_.motion, dt_});
    return std::move(step_);
  }

 private:
  double normal(std::size_t i) const { return smooth_.forces[static_cast<Eigen::Index>(2 * i)]; }

  // A force below the residual is none.
  bool is_closed(std::size_t i) const { return normal(i) > least_force_; }

  Touches closed_touches() const {
    Touches closed;
    for (std::size_t i = 0; i < parts_.smooth.size(); ++i)
      if (is_closed(i)) closed.push_back(parts_.smooth[i]);
    return closed;
  }

  void strike(const Touches& closed) {
    const auto before = vertices_at(scene_.model, scene_.reference, smooth_.q);
    step_.motion.q = without_overlap(scene_, smooth_.q, parts_.impacts, closed);
    const auto after = vertices_at(scene_.model, scene_.reference, step_.motion.q);
    const Eigen::VectorXd speeds =
        rates(contact_rows(scene_.model, scene_.reference, smooth_.q, parts_.impacts), smooth_.v);
    std::vector<Party> parties;
    for (std::size_t i = 0; i < parts_.impacts.size(); ++i) {
      const Touch& touch = parts_.impacts[i];
      const double overshoot = std::max(0.0, -gap_of(touch, before));
      if (overshoot == 0 && gap_of(touch, after) > kMeeting * scales_.size) continue;
      parties.push_back(
          {touch, surface_speed(parts_.impact_speeds[i], speeds[static_cast<Eigen::Index>(2 * i)], overshoot)});
    }
    if (parties.empty()) return;
    for (const Touch& touch : closed) parties.push_back({touch, 0});
    step_.motion.v = after_jump(scene_, step_.motion.q, step_.motion.v, parties);
  }

  // Speed where the surfaces met, not at the end of the step: v² = v1² + 2 a d with a the acceleration of the step and d the
  // overshoot (contact-notes 3, step 7).
  double surface_speed(double at_start, double at_end, double overshoot) const {
    const double acceleration = (at_end - at_start) / dt_;
    return at_end < 0 ? std::sqrt(std::max(0.0, at_end * at_end + 2 * acceleration * overshoot)) : 0;
  }

  void remember() {
    for (std::size_t i = 0; i < parts_.smooth.size(); ++i) {
      if (!is_closed(i)) continue;
      const double tangential = smooth_.forces[static_cast<Eigen::Index>(2 * i + 1)];
      step_.motion.closed[parts_.smooth[i]] = {normal(i), tangential, -tangential / scene_.tangential_stiffness()};
    }
  }

  const StandardScene& scene_;
  const Motion& start_;
  double dt_;
  double least_force_ = 0;
  UnknownsTable loads_;
  Scales scales_;
  Split parts_;
  SmoothMotion smooth_;
  StandardStep step_;
};

StandardStep in_parts(const StandardScene& scene, const Motion& start, double time, double dt, int halvings_left) {
  StandardStep whole = Attempt(scene, start, time, dt).run();
  if (whole.converged || halvings_left == 0) return whole;
  StandardStep first = in_parts(scene, start, time, dt / 2, halvings_left - 1);
  if (!first.converged) return first;
  StandardStep second = in_parts(scene, first.motion, time + dt / 2, dt / 2, halvings_left - 1);
  second.solves += first.solves + whole.solves;
  second.halvings += first.halvings + 1;
  second.account += first.account;
  second.residual = std::max(first.residual, second.residual);
  return second;
}

}  // namespace

StandardStep standard_step(const StandardScene& scene, const Motion& start, double time, double dt) {
  return in_parts(scene, start, time, dt, kMostHalvings);
}

}  // namespace keyblock
