// Glues the faces, loads the scene and dissolves the glue; see settled_start.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/settled_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/context.hpp"
#include "contact/find/connected_sets.hpp"
#include "contact/rows/gap.hpp"
#include "step/newton/tolerances.hpp"
#include "step/rest/elements_of_motion.hpp"
#include "step/scene/contact_laws.hpp"
#include "step/scene/equilibrium.hpp"
#include "step/scene/glued_faces.hpp"
#include "step/scene/step_constraints.hpp"
#include "step/scene/touch_search.hpp"
#include "step/time/smooth_solve.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

// Newton's method follows a path of solutions. Its fallback may find another one, which round-off chooses: the start of
// a slope that moves was seen to differ by 5e-6 m between frames. A step with the fallback is made again in shorter
// ones, unless its fraction of free motion changed by less than this: even sliding finds no other path.
constexpr double kLikeTheLast = 0.1;

double farthest(const UnknownsTable& ways) {
  double most = 0;
  for (const Unknowns& of : ways)
    if (of.size() > 0) most = std::max(most, of.head<2>().norm());
  return most;
}

double largest_strain(const UnknownsTable& ways) {
  double most = 0;
  for (const Unknowns& of : ways)
    if (of.size() > kRigidUnknowns) most = std::max(most, of.tail(of.size() - kRigidUnknowns).cwiseAbs().maxCoeff());
  return most;
}

// Returns the diameter of the circle around the mean of all centroids that holds them: turning does not change it.
double extent(const StandardScene& scene) {
  const auto& all = scene.reference.centroids;
  Point mean;
  for (const Point& at : all) mean = mean + 1 / static_cast<double>(all.size()) * at;
  double radius = 0;
  for (const Point& at : all) radius = std::max(radius, distance(at, mean));
  return 2 * radius;
}

// Returns true if each block moved as far as in the step before. Bodies without equilibrium then slide or fall under
// settled forces, and may do so from where they were drawn.
bool goes_on_evenly(const UnknownsTable& last, const UnknownsTable& moved) {
  return farthest(last) > 0 && farthest(plus(moved, -1, last)) <= of_settled_start::kEvenly * farthest(moved);
}

/// End of a release: the ways of its last step, and of the step before if both are equal.
struct Ending {
  UnknownsTable moved;
  UnknownsTable before = {};
  double at_rest = 0;  ///< way of a body at rest
};

// Returns the bodies whose motion ended the release, if others have not come to rest yet: sets that go on evenly, or
// else the set that moves farthest.
ChosenElements going_on_alone(const std::vector<std::size_t>& sets, const Ending& ending) {
  ChosenElements chosen(sets.size(), false);
  const bool is_even = ending.before.size() > 0;
  std::vector<double> ways(sets.size()), changes(sets.size());
  for (const ElementIndex e : indices(ending.moved)) {
    if (ending.moved[e].size() == 0) continue;
    const std::size_t set = sets[static_cast<std::size_t>(e.value)];
    ways[set] = std::max(ways[set], ending.moved[e].head<2>().norm());
    if (is_even) changes[set] = std::max(changes[set], (ending.moved[e] - ending.before[e]).head<2>().norm());
  }
  const double most = *std::ranges::max_element(ways);
  bool others_move = false;
  std::vector<bool> goes_on(sets.size(), false);
  for (std::size_t s = 0; s < ways.size(); ++s) {
    if (ways[s] <= ending.at_rest) continue;
    goes_on[s] = is_even ? changes[s] <= of_settled_start::kEvenly * ways[s] : ways[s] == most;
    others_move = others_move || !goes_on[s];
  }
  if (others_move)
    for (std::size_t e = 0; e < chosen.size(); ++e) chosen[e] = goes_on[sets[e]];
  return chosen;
}

class Settling {
 public:
  Settling(const StandardScene& scene, Motion motion) : scene_(scene), motion_(std::move(motion)) {
    velocities_ = motion_.v;
    motion_.v.set_zero();
    loads_ = loads_at(scene, motion_.q, 0);
    scales_ = scales_of(scene, loads_, motion_.q, velocities_);
    const double of_stress = reference_of_stress(scene, motion_.q);
    scales_.force = std::max(scales_.force, of_stress);
    if (of_stress > 0) extent_ = extent(scene);
  }

  Settled run() {
    found_ = resting_touches(scene_, motion_, scales_);
    drawn_ = motion_.q;
    leave_unsupported();
    if (motion_.closed.size() == 0) load_glued(scene_, found_, loads_, motion_);
    Motion before = motion_;  // keeps the compression of the glue's springs
    before.q = drawn_;
    add_overlapping(before);
    const Glued glued{motion_, found_, loads_};
    ChosenElements apart(scene_.bodies().size(), false);
    release(glued, apart);
    // Sets that go on by themselves shorten or end the steps of others: each of these lots is released alone.
    std::vector<std::size_t> sets;
    if (extent_ > 0) sets = connected(glued.found).numbers();
    std::vector<ChosenElements> alone;
    while (!sets.empty()) {
      const ChosenElements more = going_on_alone(sets, ending_);
      if (std::ranges::find(more, true) == more.end()) break;
      alone.push_back(more);
      for (std::size_t e = 0; e < apart.size(); ++e) apart[e] = apart[e] || more[e];
      release(glued, apart);
    }
    for (const ChosenElements& lot : alone) {
      Motion others = std::move(motion_);
      const double left = left_;
      for (std::size_t e = 0; e < apart.size(); ++e) apart[e] = !lot[e];
      release(glued, apart);
      motion_ = with_elements_of(scene_, lot, motion_, std::move(others));
      left_ = std::max(left, left_);
    }
    motion_.v = velocities_;
    return {std::move(motion_), unsolved_, left_};
  }

 private:
  struct Glued {
    Motion motion;
    Touches found;
    UnknownsTable loads;
  };

  ConnectedSets connected(const Touches& touches) const {
    std::vector<ElementIndex> supported;
    for (const HeldPair& pair : scene_.held) supported.push_back(pair.element);
    return {scene_.model, pairs_of(scene_.model, touches), supported};
  }

  // Removes the loads from connected sets without a fixed block or fixed point: their forces cannot settle here.
  void leave_unsupported() {
    const ConnectedSets sets = connected(found_);
    for (const ElementIndex e : indices(loads_))
      if (!sets.is_held(e)) loads_[e].setZero();
  }

  // Releases the glue. Bodies set apart have no load, and stay about where they are.
  void release(const Glued& glued, const ChosenElements& apart) {
    const auto begin = [&] {
      motion_ = glued.motion;
      found_ = glued.found;
      moved_ = {};
      searches_anew_ = false;
      share_of_wall_ = 0;
    };
    apart_ = apart;
    loads_ = glued.loads;
    for (const ElementIndex e : indices(loads_))
      if (is_apart(e)) loads_[e].setZero();
    begin();
    const double longest = dissolve(of_settled_start::kLongest);
    if (longest == 0) return;
    begin();
    dissolve(longest);
  }

  bool is_apart(ElementIndex e) const { return apart_[static_cast<std::size_t>(e.value)]; }

  // Returns zero, or the length that steps of another attempt should have at most, because the scene slid too far.
  double dissolve(double longest) {
    double stiffness = of_settled_start::kShortest;
    left_ = 0;
    double first_share = 0;
    double last_share = 1;  // of free fall
    double least_share = std::numeric_limits<double>::infinity();
    int stalls = 0;  // steps since then
    Motion before_stalls;
    double slid = 0;  // sum of `stiffness` over the steps so far
    for (int i = 0; i < of_settled_start::kMostSteps; ++i) {
      const Motion before = motion_;
      const Touches found = found_;
      const UnknownsTable last = moved_;
      if (!step(stiffness)) {
        ++unsolved_;
        const double growth = of_settled_start::kGrowth;
        stiffness *= stiffness > of_settled_start::kShortest ? 1 / growth : growth;
        continue;
      }
      const double moved = farthest(moved_);
      const double share = 2 * moved * scene_.normal_stiffness() / (stiffness * scales_.force);
      const bool rises = slid > 0 && share > of_settled_start::kRises * last_share;
      // The end of a row of stressed blocks moves by the sum of their strains, and so do gaps that open.
      const double stretched = 2 * extent_ * largest_strain(moved_);
      const bool is_far = moved > std::max(of_settled_start::kFarthestOfSettling * scales_.size, stretched);
      const bool leaves_path = slid > 0 && longest < of_settled_start::kLongest && took_fallback_ &&
                               std::abs(share - last_share) > kLikeTheLast * last_share;
      if ((rises || is_far || leaves_path) && stiffness > of_settled_start::kShortest) {
        motion_ = before;
        found_ = found;
        moved_ = last;
        const double shorter = rises || is_far ? of_settled_start::kShorter : of_settled_start::kGrowth;
        stiffness = std::max(stiffness / shorter, of_settled_start::kShortest);
        continue;
      }
      if (slid == 0) first_share = share;
      slid += stiffness;
      ending_ = {moved_, {}, of_settled_start::kAtRest * stiffness * scales_.force / (2 * scene_.normal_stiffness())};
      const double before_share = std::exchange(last_share, share);
      tell_headway("start, glued blocks let go",
                   std::max(double(i + 1) / of_settled_start::kMostSteps,
                            share_of_fall(first_share, share, of_settled_start::kAtRest)));
      if (share <= of_settled_start::kAtRest && std::exchange(searches_anew_, true)) return 0;
      if (goes_on_evenly(last, moved_)) {
        const double way = slid / stiffness * moved;
        const double most = of_settled_start::kFarthestSlide * scales_.size;
        if (way > most && longest == of_settled_start::kLongest)
          return std::max(stiffness * most / way, of_settled_start::kShortest);
        take_back(slid / stiffness);
        ending_.before = last;
        return 0;
      }
      if (share <= of_settled_start::kStalls * least_share) {
        least_share = share;
        stalls = 0;
      } else if (++stalls == 1) {
        before_stalls = before;
      } else if (stalls == of_settled_start::kMostStalls) {
        motion_ = std::move(before_stalls);
        return 0;
      }
      const bool is_near = moved <= std::max(of_settled_start::kFarthest * scales_.size, stretched);
      const bool is_settling = share <= of_settled_start::kSettles * std::min(1.0, before_share);
      const bool is_held = first_share <= of_settled_start::kHeld;
      if (is_near || is_settling) stiffness *= is_held ? of_settled_start::kGrowthOfHeld : of_settled_start::kGrowth;
      share_of_wall_ = is_held && found_.size() > FrictionalProblem::kVeryManyPairs ? share : 0;
      stiffness = std::min({stiffness, longest, longest_of_wall()});
    }
    left_ = last_share;
    return 0;
  }

  // Returns the limit of the next step of a large wall.
  double longest_of_wall() const {
    if (share_of_wall_ == 0) return of_settled_start::kLongest;
    return searches_anew_ ? of_settled_start::kLastOfWall : of_settled_start::kLongestOfWall;
  }

  // Takes back `share` of the last step's motion, but no body farther than to where it was drawn.
  void take_back(double share) {
    const UnknownsTable made = plus(motion_.q, -1, drawn_);
    for (const ElementIndex e : indices(moved_)) {
      if (moved_[e].size() == 0) continue;
      const double way = share * moved_[e].head<2>().norm();
      const double most = made[e].head<2>().norm();
      motion_.q[e] -= (way > most ? share * most / way : share) * moved_[e];
    }
  }

  // Makes an iteration of statics (7.9 in docs/theory/07-initial-state-and-statics.md). Returns false if it finds no
  // forces. It then moves nothing, but contacts that it found stay.
  bool step(double stiffness_over_inertia) {
    const double tau = std::sqrt(stiffness_over_inertia * heaviest(scene_.bodies()) / scene_.normal_stiffness());
    StepRule rule = resting_rule(tau / std::numbers::sqrt2);
    rule.breaks_bonds = true;  // the release of the glue is a load path of its own
    if (searches_anew_) {
      found_ = touches_of(scene_, motion_, scales_, scene_.settings.time_step);
      leave_overlaps(scene_, motion_, scales_, found_);
    }
    const bool are_very_many = found_.size() > FrictionalProblem::kVeryManyPairs;
    const double good = std::max(of_settled_start::kForceTolerance, of_settled_start::kOfShare * share_of_wall_);
    const double goal = are_very_many ? good : of_settled_start::kForceGoal;
    const ForceTolerance tolerance{goal * scales_.force, good * scales_.force,
                                   of_settled_start::kForceTolerated * scales_.force};
    SmoothMotion made = smooth_solve(scene_, motion_, loads_, found_, tolerance, -1, 1, rule);
    for (int search = 1; search < of_settled_start::kMostSearches && made.converged; ++search) {
      const Touches fresh = overlapping_at(made.q, motion_);
      if (fresh.empty()) break;
      found_.insert(found_.end(), fresh.begin(), fresh.end());
      made = smooth_solve(scene_, motion_, loads_, found_, tolerance, -1, 1, rule, &made);
    }
    took_fallback_ = made.fallbacks > 0;
    if (!made.converged) return false;
    moved_ = plus(made.q, -1, motion_.q);
    for (const ElementIndex e : indices(moved_))
      if (is_apart(e)) moved_[e].setZero();
    const Eigen::VectorXd way = rates(made.rows, moved_);
    motion_.q = std::move(made.q);
    motion_.bonds = std::move(made.bonds);
    motion_.constraints = std::move(made.constraints);
    std::vector<ClosedContact> closed;
    for (std::size_t i = 0; i < found_.size(); ++i) {
      const auto n = static_cast<Eigen::Index>(2 * i);
      const Touch& touch = found_[i];
      if (made.forces[n] != 0 || made.laws[i].is_bonded)
        closed.push_back(
            {touch, memory_of(made.laws[i], made.forces[n], made.forces[n + 1], way[n + 1], motion_.closed.of(touch))});
    }
    motion_.closed = ClosedContacts(std::move(closed));
    return true;
  }

  // Corners at nodes of more than two blocks, and corners that came round an edge, are not faces. Without them blocks
  // would slip past each other.
  Touches overlapping_at(const UnknownsTable& q, const Motion& before) const {
    return newly_overlapping(scene_, before, vertices_at(scene_.model, scene_.reference, q), found_, scales_);
  }
  void add_overlapping(const Motion& before) {
    const Touches fresh = overlapping_at(motion_.q, before);
    found_.insert(found_.end(), fresh.begin(), fresh.end());
  }

  const StandardScene& scene_;
  Motion motion_;
  UnknownsTable drawn_;
  UnknownsTable velocities_;
  UnknownsTable loads_;
  Scales scales_;
  Touches found_;
  bool searches_anew_ = false;  ///< as the run will, once the contacts of the drawing are at rest
  UnknownsTable moved_;         ///< in the last step that was solved
  double share_of_wall_ = 0;    ///< of free motion, in the last step of a large wall
  double extent_ = 0;           ///< of the scene; 0 without initial stress
  int unsolved_ = 0;
  bool took_fallback_ = false;  ///< in the last step
  double left_ = 0;             ///< see Settled
  ChosenElements apart_;        ///< bodies that this release leaves out
  Ending ending_;
};

}  // namespace

Settled settled(const StandardScene& scene, Motion motion) {
  return Settling(scene, std::move(motion)).run();
}

}  // namespace keyblock
