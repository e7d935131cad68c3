// Iterates in pseudo time, which grows with success and is cut if blocks move too far for one linearisation.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/static_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/context.hpp"
#include "contact/rows/gap.hpp"
#include "step/bodies/integrator.hpp"
#include "step/newton/tolerances.hpp"
#include "step/scene/contact_laws.hpp"
#include "step/scene/equilibrium.hpp"
#include "step/scene/touch_search.hpp"
#include "step/time/smooth_solve.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

// Travel from the last rest, as `travel_of` measures it, beyond which a bond that is overloaded breaks: the way then
// leads to no rest that the bond could bear.
constexpr double kFarFromRest = 1e-3;

// Share, in the first τ, of the force by which a body answers the way of its driven points by strain alone. The whole
// force costs two iterations more; without it a clamped wedge slips.
constexpr double kOfStrain = 1e-2;

// Round-off of a gap over the farthest coordinate: two units of the last place.
constexpr double kRoundOff = 5e-16;

// Returns the force by which springs answer the round-off of gaps far from the origin: no balance is better.
double force_of_round_off(const StandardScene& scene) {
  double farthest = 0;
  for (const Point place : scene.model.start_vertices) farthest = std::max(farthest, length(place));
  return scene.has_springs() ? kRoundOff * farthest * scene.normal_stiffness() : 0;
}

// Forces of an earlier stage may be beyond the strength of joints that have become weaker.
bool has_permitted_forces(const StandardScene& scene, const Motion& motion, double load) {
  const double tolerance = of_statics::kForceAcceptable * load;
  return std::ranges::all_of(motion.closed.all(), [&](const ClosedContact& contact) {
    const ForceLaw law = contact_law(scene, motion.bonds, contact.touch).force;
    return contact.memory.normal >= law.least - tolerance &&
           std::abs(contact.memory.tangential) <= law.limit(contact.memory.normal) + tolerance;
  });
}

MassRange mass_range(const StandardScene& scene) {
  MassRange range;
  for (const auto& group : scene.groups) group->add_to(range, scene.has_springs() ? scene.normal_stiffness() : 0);
  for (const Bolt& bolt : scene.model.bolts)
    if (bolt.is_spring()) range.slowest = std::min(range.slowest, std::sqrt(bolt.stiffness / range.heaviest));
  return range;
}

class StaticSolve {
 public:
  StaticSolve(const StandardScene& scene, const Motion& start, double time, int most_iterations)
      : scene_(scene),
        start_(start),
        time_(time),
        most_iterations_(most_iterations),
        slip_start_(start),
        points_(start.points),
        closed_(start.closed),
        may_yield_(keyblock::may_yield(scene)) {
    slip_start_.v.set_zero();
    now_ = slip_start_;
    rested_ = now_.q;
  }

  StandardStep run() {
    if (!choose_scales()) return finished();
    if (!std::isfinite(load_)) {
      result_.residual = 1;
      result_.failure = {"loads_not_finite"};
      return finished();
    }
    const Balance at_start = balance_of(scene_, start_, time_, load_);
    result_.residual = at_start.share;
    if (at_start.holds() && start_.bonds.empty() && has_permitted_forces(scene_, start_, load_)) {
      for (const auto& [touch, memory] : closed_.all()) result_.touches.push_back(touch);
      return finished();
    }
    result_.residual = 1;  // everything is out of balance
    for (; iterations_ < most_iterations_ && result_.failure.empty() && result_.converged; ++iterations_) {
      if (!iterate()) continue;
      if (!overloaded_.empty() && travel_of(scene_, rested_, now_.q).share > kFarFromRest) break_overloaded();
      const Balance balance = balance_of(scene_, now_, time_, load_);
      bound_by(balance.share);
      way_ = std::max(way_, share_of_fall(1, balance.share, of_statics::kBalancedToBegin));  // residuals may rise
      tell_headway("search for the equilibrium", way_);
      result_.residual = balance.share;
      if (balance.holds() || settles_for_less()) {
        if (overloaded_.empty()) return finished();
        break_overloaded();
        continue;
      }
      result_.moving = far_out_of_balance(balance);
      if (!result_.moving.empty()) result_.failure = no_equilibrium(scene_, result_.moving);
    }
    if (result_.converged && result_.failure.empty())
      result_.failure = {"no_equilibrium_found", {{{"iterations", iterations_}, {"residual", result_.residual}}}};
    return finished();
  }

 private:
  StandardStep finished() {
    result_.solves = solves_;
    result_.halvings = cuts_;
    now_.v.set_zero();
    result_.motion = now_;
    result_.motion.points = points_;
    result_.motion.closed = closed_;
    return std::move(result_);
  }

  // Returns false if there is no load to balance. Once the last load is gone, the strain that it left is one.
  bool choose_scales() {
    const UnknownsTable loads = loads_at(scene_, now_.q, time_);
    const MassRange range = mass_range(scene_);
    const bool can_strain = range.slowest < std::numeric_limits<double>::max();
    load_ = std::max(largest_load(scene_, loads), driving_force(scene_, start_, time_, scene_.settings.time_step));
    const Scales scales = scales_of(scene_, loads, now_.q, now_.v);
    if (load_ == 0) load_ = force_of_strain(of_statics::kNoStrain * scene_.normal_stiffness() * scales.size);
    if (load_ == 0) return false;
    first_load_ = load_ = std::max(load_, force_of_round_off(scene_) / of_statics::kBalanceAcceptable);
    // A driven point strains what it moves: a first τ of its time step would throw bodies about.
    const double at_once = can_strain ? driving_force(scene_, start_, time_, 1 / range.slowest) : 0;
    tau_ = std::sqrt(of_statics::kFarthest * scales.size * range.lightest / std::max(load_, kOfStrain * at_once));
    const double longest = range.all_strain ? of_statics::kLongest : of_statics::kLongestOfRigid;
    longest_ = can_strain ? longest / range.slowest : longest * tau_;
    tau_ = std::min(tau_, longest_);
    // Initial stress presses faces together before weight moves the blocks: a longer first τ lets wedges fall out.
    if (is_stressed(scene_, now_.q)) tau_ = std::min(tau_, longest_ / longest);
    return true;
  }

  // Returns the largest force out of balance; zero up to `none`.
  double force_of_strain(double none) const {
    if (!(none > 0)) return 0;
    const double force = none * balance_of(scene_, start_, time_, none).share;
    return force > none ? force : 0;
  }

  void bound_by(double share) {
    bound_ = turned_back_ && share > result_.residual ? of_statics::kAfterRise * std::min(used_, bound_)
                                                      : of_statics::kRaised * bound_;
    tau_ = std::min(tau_, bound_);
  }

  // Checks every few iterations whether the imbalance still falls. If not, it may be at the accuracy of contact forces.
  // Otherwise a longer τ moves slow modes, or reveals an acceleration.
  bool settles_for_less() {
    if (++since_look_ < of_statics::kLook) return false;
    since_look_ = 0;
    const bool falls = result_.residual < of_statics::kFalls * last_look_;
    last_look_ = result_.residual;
    if (falls) return false;
    longest_ *= of_statics::kLonger;
    return result_.residual <= of_statics::kBalanceAcceptable;
  }

  // On the way to rest a block may press on a neighbour that it then leaves.
  void break_overloaded() {
    for (const Facing& facing : overloaded_) now_.bonds.erase(facing);
    overloaded_.clear();
    rested_ = now_.q;
    last_look_ = std::numeric_limits<double>::infinity();
    since_look_ = 0;
  }

  // Returns true if the iteration is accepted; otherwise τ was cut.
  bool iterate() {
    ++solves_;
    const UnknownsTable loads = loads_at(scene_, now_.q, time_);
    Motion still = now_;
    still.v.set_zero();
    const Scales scales = scales_of(scene_, loads, still.q, still.v);
    Touches found = touches_of(scene_, still, scales, tau_);
    const ForceTolerance tolerance{
        of_statics::kForceGoal * load_,
        std::max(of_statics::kForceAcceptable, of_statics::kForceOnTheWay * result_.residual) * load_};
    SmoothMotion made;
    Touches touches;
    for (int search = 0; search < of_statics::kMostSearches; ++search) {
      touches = found;
      made = smooth_solve(scene_, now_, loads, touches, tolerance, time_ - 1, 1, resting_rule(tau_));
      if (made.fallbacks > 0) ++result_.fallbacks;
      const auto end = vertices_at(scene_.model, scene_.reference, made.q);
      const Touches fresh = made.converged ? newly_overlapping(scene_, still, end, found, scales) : Touches{};
      if (fresh.empty()) break;
      found.insert(found.end(), fresh.begin(), fresh.end());
    }
    const double moved = travel_of(scene_, now_.q, made.q).share;
    if ((!made.converged || !(moved <= of_statics::kFarthest)) && cut(made, touches)) return false;
    if (!made.converged) return false;
    accept(made, touches, tolerance.goal);
    used_ = tau_;
    const double wanted = tau_ * std::clamp(std::sqrt(of_statics::kAimed * of_statics::kFarthest / moved),
                                            1 / of_statics::kGrowth, growth_);
    tau_ = std::min(wanted, longest_);
    cuts_in_row_ = 0;
    return true;
  }

  bool cut(const SmoothMotion& made, const Touches& touches) {
    if (++cuts_in_row_ > of_statics::kMostCuts) {
      result_.converged = made.converged;
      result_.residual = made.residual / load_;
      result_.touches = touches;
      result_.undecided = made.undecided;
      return false;
    }
    ++cuts_;
    tau_ /= of_statics::kGrowth;
    if (!made.converged) growth_ = of_statics::kGrowthAfterCut;
    return true;
  }

  void accept(const SmoothMotion& made, const Touches& touches, double least_force) {
    result_.touches = touches;
    const UnknownsTable moved = plus(made.q, -1, now_.q);
    turned_back_ = !moved_.empty() && dot(moved, momentum(scene_, moved_)) < 0;
    moved_ = moved;
    now_.q = made.q;
    points_ = made.points;
    if (may_yield_ && !touches.empty())
      load_ =
          std::max(first_load_, made.forces.head(static_cast<Eigen::Index>(2 * touches.size())).cwiseAbs().maxCoeff());
    now_.bonds = made.bonds;
    overloaded_ = made.overloaded;
    now_.constraints = made.constraints;
    std::vector<ClosedContact> closed;
    for (std::size_t i = 0; i < touches.size(); ++i) {
      const auto n = static_cast<Eigen::Index>(2 * i);
      const bool holds = std::abs(made.forces[n]) > least_force || made.laws[i].is_bonded;
      if (holds) closed.push_back({touches[i], memory_of(made.laws[i], made.forces[n], made.forces[n + 1])});
    }
    closed_ = ClosedContacts(closed);
    if (one_closed()) {
      slip_start_ = now_;
      slip_start_.closed = closed_;
    }
    now_.v = plus(now_.q, -1, slip_start_.q);
    for (auto& [touch, memory] : closed) {
      const ContactMemory* known = slip_start_.closed.of(touch);
      memory.stretch = known ? known->stretch : 0;
    }
    now_.closed = ClosedContacts(std::move(closed));
  }

  // Returns true if a contact closed that was open at the start of slip counting.
  bool one_closed() const {
    const auto then = vertices_at(scene_.model, scene_.reference, slip_start_.q);
    return std::ranges::any_of(closed_.all(), [&](const auto& entry) {
      const double size = scene_.bodies()[scene_.model.vertices[entry.touch.vertex].element].size;
      return gap_of(entry.touch, then) > of_statics::kClosedThen * size;
    });
  }

  // Returns blocks that moved far while out of balance. If the imbalance stays the same for many iterations, a block
  // accelerates: a shorter distance then suffices to name it.
  std::vector<ElementIndex> far_out_of_balance(const Balance& balance) {
    const bool is_same = std::abs(balance.share - steady_share_) <= of_statics::kSame * steady_share_;
    steady_ = is_same ? steady_ + 1 : 0;
    if (!is_same) steady_share_ = balance.share;
    const double far = steady_ < of_statics::kSteady ? 1 : of_statics::kFarIfSteady;
    std::vector<ElementIndex> blocks;
    std::ranges::set_intersection(travel_of(scene_, start_.q, now_.q, far).far, balance.blocks,
                                  std::back_inserter(blocks));
    return blocks;
  }

  const StandardScene& scene_;
  const Motion& start_;
  double time_;
  int most_iterations_;
  Motion slip_start_;     ///< origin of slip and spring stretch
  Motion now_;            ///< v is the displacement since `slip_start_`, over unit time; springs are stretched as there
  PointMemories points_;  ///< at the last iteration; each begins with those of the start
  ClosedContacts closed_;  ///< with their present stretch
  bool may_yield_;
  double first_load_ = 0;  ///< largest load, or driving force of fixed points
  double load_ = 0;        ///< reference of the balance; with plastic flow at least the largest contact force
  double tau_ = 0;
  double used_ = 0;                                         ///< τ of the last accepted iteration
  double bound_ = std::numeric_limits<double>::infinity();  ///< upper bound of τ after a rise of the imbalance
  double longest_ = 0;
  double growth_ = of_statics::kGrowth;
  UnknownsTable moved_;             ///< in the last accepted iteration
  std::vector<Facing> overloaded_;  ///< bonds, in the last accepted iteration
  UnknownsTable rested_;            ///< where they last broke, or the start
  bool turned_back_ = false;
  int since_look_ = 0;                                          ///< iterations
  double last_look_ = std::numeric_limits<double>::infinity();  ///< imbalance at the last check
  double steady_share_ = 0;                                     ///< imbalance that has stayed the same
  int steady_ = 0;                                              ///< iterations with that imbalance
  int iterations_ = 0;
  double way_ = 0;  ///< reported progress towards balance
  int solves_ = 0;  ///< iterations, discarded ones included
  int cuts_ = 0;
  int cuts_in_row_ = 0;
  StandardStep result_;
};

}  // namespace

StandardStep static_step(const StandardScene& scene, const Motion& start, double time, int most_iterations) {
  return StaticSolve(scene, start, time, most_iterations).run();
}

}  // namespace keyblock
