// Makes steps of pseudo time until lengths no longer change, and takes the motion back; see moving_start.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/moving_start.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/context.hpp"
#include "contact/rows/gap.hpp"
#include "step/bodies/integrator.hpp"
#include "step/newton/tolerances.hpp"
#include "step/scene/contact_laws.hpp"
#include "step/scene/step_constraints.hpp"
#include "step/scene/touch_search.hpp"
#include "step/time/smooth_solve.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

class MovingStart {
 public:
  MovingStart(const StandardScene& scene, const Motion& start)
      : scene_(scene),
        start_(start),
        loads_(loads_at(scene, start.q, 0)),
        scales_(scales_of(scene, loads_, start.q, start.v)),
        now_(start),
        lengths_(edge_lengths()),
        drawn_(lengths_) {
    for (const Point place : scene.model.start_vertices) farthest_ = std::max(farthest_, length(place));
  }

  std::optional<Motion> run() {
    if (!(scales_.acceleration > 0)) return std::nullopt;
    for (int step = 1; step <= of_moving_start::kMostSteps; ++step) {
      leave_if_stopped();
      const double reach = std::max(of_moving_start::kReach * scales_.size, of_moving_start::kOverStrain * strain_);
      tau_ = std::sqrt(reach / scales_.acceleration);
      reached_ += reach;
      if (!make_step()) return std::nullopt;
      const bool breaks = !overloaded_.empty();
      for (const Facing& facing : overloaded_) now_.bonds.erase(facing);
      if (has_settled() && !breaks) return taken_back(reached_ / reach);
    }
    return std::nullopt;
  }

 private:
  bool make_step() {
    Motion still = now_;
    still.v.set_zero();
    now_.v = start_.v;
    now_.v *= tau_;
    Touches touches = touches_of(scene_, still, scales_, tau_);
    const ForceTolerance tolerance{of_statics::kForceGoal * scales_.force, of_statics::kForceOnTheWay * scales_.force};
    SmoothMotion made;
    for (int search = 0; search < of_statics::kMostSearches; ++search) {
      made = smooth_solve(scene_, now_, loads_, touches, tolerance, -1, 1, resting_rule(tau_));
      if (!made.converged) return false;
      const auto end = vertices_at(scene_.model, scene_.reference, made.q);
      const Touches fresh = newly_overlapping(scene_, still, end, touches, scales_);
      if (fresh.empty()) break;
      touches.insert(touches.end(), fresh.begin(), fresh.end());
    }
    increment_ = plus(made.q, -1, now_.q);
    now_.q = made.q;
    now_.points = made.points;
    now_.bonds = made.bonds;
    now_.constraints = made.constraints;
    overloaded_ = made.overloaded;
    std::vector<ClosedContact> closed;
    for (std::size_t i = 0; i < touches.size(); ++i) {
      const auto n = static_cast<Eigen::Index>(2 * i);
      if (std::abs(made.forces[n]) > tolerance.goal || made.laws[i].is_bonded)
        closed.push_back({touches[i], memory_of(made.laws[i], made.forces[n], made.forces[n + 1])});
    }
    now_.closed = ClosedContacts(std::move(closed));
    return true;
  }

  // Rigid motion changes no length, so that lengths show the strain alone.
  bool has_settled() {
    const std::vector<double> before = std::exchange(lengths_, edge_lengths());
    double change = 0;
    for (std::size_t i = 0; i < lengths_.size(); ++i) {
      change = std::max(change, std::abs(lengths_[i] - before[i]));
      strain_ = std::max(strain_, std::abs(lengths_[i] - drawn_[i]));
    }
    return change <= std::max(of_moving_start::kSettled * strain_, of_moving_start::kRoundOff * farthest_);
  }

  std::vector<double> edge_lengths() const {
    const auto vertices = vertices_at(scene_.model, scene_.reference, now_.q);
    std::vector<double> lengths;
    for (const Element& element : scene_.model.elements) {
      if (!element.can_move()) continue;
      std::optional<VertexIndex> last;
      for (const VertexIndex vertex : element.vertices()) {
        if (last) lengths.push_back(distance(vertices[*last], vertices[vertex]));
        last = vertex;
      }
    }
    return lengths;
  }

  std::optional<Motion> taken_back(double steps) {
    const auto gaps_of = [&](const UnknownsTable& q) {
      const auto vertices = vertices_at(scene_.model, scene_.reference, q);
      std::vector<double> gaps;
      for (const auto& [touch, memory] : now_.closed.all()) gaps.push_back(gap_of(touch, vertices));
      return gaps;
    };
    const std::vector<double> with_motion = gaps_of(now_.q);
    now_.q = plus(now_.q, -steps, increment_);
    const std::vector<double> without = gaps_of(now_.q);
    for (std::size_t i = 0; i < without.size(); ++i)
      if (without[i] - with_motion[i] > of_statics::kClosedThen * scales_.size) return std::nullopt;
    put_bolt_forces(scene_, now_);
    now_.v = start_.v;
    return std::move(now_);
  }

  const StandardScene& scene_;
  const Motion& start_;
  UnknownsTable loads_;
  Scales scales_;
  Motion now_;
  std::vector<double> lengths_;  ///< of the edges of all elements
  std::vector<double> drawn_;    ///< the same at the start
  double strain_ = 0;            ///< greatest change of one of them
  double farthest_ = 0;          ///< distance of a vertex from the origin
  double tau_ = 0;
  double reached_ = 0;       ///< length of free fall in all steps
  UnknownsTable increment_;  ///< of the last step
  std::vector<Facing> overloaded_;
};

}  // namespace

std::optional<Motion> moving_start(StandardScene scene, const Motion& start) {
  return MovingStart(scene, start).run();
}

}  // namespace keyblock
