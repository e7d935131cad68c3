// Relinearises gaps and rows about the last estimate until the estimate converges.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/smooth_solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/context.hpp"
#include "step/newton/newton.hpp"
#include "step/time/free_motion.hpp"
#include "step/time/smooth_contacts.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

class SmoothSolve {
 public:
  SmoothSolve(const StandardScene& scene, const Motion& start, const UnknownsTable& loads, const Touches& touches,
              const ForceTolerance& tolerance, double time, double dt, const StepRule& rule, const SmoothMotion* before)
      : tolerance_(tolerance),
        breaks_bonds_(rule.breaks_bonds),
        free_(scene, start, loads, rule, dt),
        contacts_(scene, start, touches, tolerance, time, dt, rule, free_) {
    starts_otherwise_ = free_.is_linear() && (before != nullptr || free_.goes_on_with_acceleration());
    increments_ = is_linear() ? free_.increments() : before ? plus(before->q, -1, start.q) : free_.going_on();
    result_.forces = before ? contacts_.forces_of(*before) : contacts_.remembered_forces();
  }

  SmoothMotion run() {
    do {
      settle();
      if (!result_.converged && starts_otherwise_) settle_from_velocity();
    } while (result_.converged && breaks_bonds_ && contacts_.break_bonds(result_.forces));
    if (result_.converged && !breaks_bonds_) result_.overloaded = contacts_.overloaded_bonds(result_.forces);
    if (result_.residual > contacts_.problem().goal) result_.worst = worst_pair(contacts_.problem(), result_.forces);
    static_cast<BodiesMotion&>(result_) = free_.end(increments_, result_.converged);
    std::move(contacts_).put_end(result_);
    result_.flexibility = std::move(free_).take_flexibility();
    return std::move(result_);
  }

  // The interface to `newton`: iterations are judged by their change.

  RoundsEnd state() const {
    if (!result_.converged) return RoundsEnd::no_contact_forces;
    if (change_ <= of_smooth_motion::kSettled || is_round_off()) return RoundsEnd::balanced;
    return std::isfinite(change_) ? RoundsEnd::open : RoundsEnd::not_finite;
  }

  RoundsEnd find_increment(int round) {
    const bool rows_moved = round > 0 && round < of_smooth_motion::kMostRows &&
                            free_.greatest_change(increments_, linearised_) > same_rows();
    const bool falls_slowly = !free_.is_linear() && round > 1 && change_ > of_smooth_motion::kWorstGain * before_;
    is_new_tangent_ = round == 0 || (falls_slowly && may_be_tangent());
    if (is_new_tangent_) {
      begin_system();
      result_.converged = free_.linearise(increments_);
      tangent_at_ = increments_;
    }
    if (!result_.converged) return RoundsEnd::no_factor;
    if (is_new_tangent_ || rows_moved) {
      linearised_ = increments_;
      contacts_.linearise(increments_);
    }
    before_ = change_;
    free_.evaluate(increments_);
    contacts_.set_right_side(increments_);
    Tried now = tried(contacts_.problem(), result_.forces);
    unsolved_ = residual(contacts_.problem(), now);
    if (round > 0 && !rows_moved && is_good_enough(unsolved_)) return RoundsEnd::balanced;
    ++result_.rounds;
    const int fallbacks = result_.fallbacks;
    next_ = next_increments(std::move(now));
    change_ = free_.greatest_change(increments_, next_);
    // Gaps of rounded corners turn with the way along them. Rows that give half of their slope make whole increments
    // alternate between two estimates.
    alternates_ = free_.is_linear() && !contacts_.springs_stop() && result_.fallbacks == fallbacks && round > 1 &&
                  change_ > of_line_search::kStalls * before_;
    stalls_ += stalls() ? 1 : 0;
    return RoundsEnd::open;
  }

  bool has_kinks() const { return free_.has_kinks() || alternates_; }
  double change_over_last() const { return change_ / before_; }
  void take(double part) {
    increments_ = part < 1 ? plus(increments_, part, plus(next_, -1, increments_)) : std::move(next_);
  }

 private:
  void settle() {
    contacts_.take_laws();
    result_.converged = true;
    change_ = is_linear() ? 0 : 1;
    unsolved_ = std::numeric_limits<double>::infinity();
    before_ = change_;
    stalls_ = 0;
    PartsByChange search;
    result_.end = newton(*this, search, most_rounds());
    if (result_.end == RoundsEnd::no_factor) return;
    // NMM bodies are not linear: forces that meet the gaps do not imply balance.
    const bool forces_suffice = free_.is_linear() && std::isfinite(change_) &&
                                unsolved_ <= std::max(contacts_.problem().acceptable, tolerance_.tolerated);
    const double tolerable = free_.has_kinks() ? of_smooth_motion::kTolerableOfYield : of_smooth_motion::kTolerable;
    const bool has_settled = change_ <= tolerable || forces_suffice;
    // The forces of two estimates may each solve their own gaps: what is unsolved is their error in those of the other.
    if (!has_settled && free_.is_linear() && std::isfinite(unsolved_))
      result_.residual = std::max(result_.residual, unsolved_);
    result_.converged = result_.converged && has_settled;
  }

  // Retries from the velocity alone, for blocks that the last acceleration would carry away. Examples are a sliver free
  // of its neighbours, and the first step.
  void settle_from_velocity() {
    increments_ = free_.steady();
    result_.forces = contacts_.remembered_forces();
    settle();
  }

  // A tangent about almost the same estimate is not the reason for slow changes. Forces that are acceptable but no
  // better keep shifting among pairs that carry the same load.
  bool may_be_tangent() const {
    return free_.has_kinks() || free_.greatest_change(increments_, tangent_at_) > of_smooth_motion::kSameTangent;
  }

  // A change this small would be accepted after the last iteration. If new tangents have failed to reduce it several
  // times, later ones will too.
  bool is_round_off() const { return stalls_ >= of_smooth_motion::kStallsOfRoundOff; }
  bool stalls() const {
    return free_.has_kinks() && is_new_tangent_ && change_ <= of_smooth_motion::kTolerableOfYield &&
           change_ > of_line_search::kStalls * before_;
  }

  // Very many pairs, between DDA blocks only, permit coarser updates.
  bool is_coarse() const { return free_.is_linear() && contacts_.touch_count() > FrictionalProblem::kVeryManyPairs; }

  double same_rows() const {
    if (is_coarse()) return of_smooth_motion::kSameRowsOfMany;
    const bool are_few = contacts_.touch_count() <= FrictionalProblem::kFewPairs;
    return are_few ? of_smooth_motion::kSameRowsOfFew : of_smooth_motion::kSameRows;
  }

  // Returns true if the gap error of the forces at the last estimate is negligible against their goal, or hardly larger
  // than before.
  bool is_good_enough(double unsolved) const {
    return is_coarse() && unsolved <= std::max(of_smooth_motion::kGoalsOfEstimate * contacts_.problem().goal,
                                               of_smooth_motion::kOfLast * result_.residual);
  }

  int most_rounds() const {
    if (free_.has_kinks()) return of_smooth_motion::kMostRoundsOfYield;
    return contacts_.springs_stop() ? of_smooth_motion::kMostRoundsOfSprings : of_smooth_motion::kMostRounds;
  }

  bool is_linear() const { return contacts_.is_empty() && free_.is_linear(); }

  UnknownsTable next_increments(Tried now) {
    FrictionalProblem& problem = contacts_.problem();
    const FrictionalSolution solution = solve(problem, std::move(now), &contacts_.kept());
    result_.forces = solution.forces;
    result_.solves += solution.solves;
    result_.fallbacks += solution.fallbacks;
    result_.residual = solution.residual;
    result_.is_tolerated = !solution.converged && solution.residual <= tolerance_.tolerated;
    result_.converged = solution.converged || result_.is_tolerated;
    result_.undecided = solution.undecided;
    return plus(free_.increments(), 1, answer(contacts_.rows(), free_.flexibility(), solution.forces));
  }

  ForceTolerance tolerance_;
  bool breaks_bonds_;
  FreeMotion free_;
  SmoothContacts contacts_;
  UnknownsTable increments_;
  UnknownsTable next_;  ///< of the iteration
  double change_ = 0;   ///< by the last iteration
  double before_ = 0;   ///< by the iteration before it
  bool is_new_tangent_ = false;
  bool starts_otherwise_ = false;  ///< differently than from the velocity
  bool alternates_ = false;        ///< blocks: the last change is as large as the one before
  int stalls_ = 0;                 ///< iterations of tolerable changes that a new tangent did not reduce
  double unsolved_ = 0;            ///< residual of the last iteration's forces in the gaps of this one
  UnknownsTable tangent_at_;       ///< increments about which the matrix was made
  UnknownsTable linearised_;       ///< increments about which rows and the matrix of forces were made
  SmoothMotion result_;
};

}  // namespace

SmoothMotion smooth_solve(const StandardScene& scene, const Motion& start, const UnknownsTable& loads,
                          const Touches& touches, const ForceTolerance& tolerance, double time, double dt,
                          const StepRule& rule, const SmoothMotion* before) {
  return SmoothSolve(scene, start, loads, touches, tolerance, time, dt, rule, before).run();
}

}  // namespace keyblock
