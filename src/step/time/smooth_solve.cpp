// Relinearises gaps and rows about the last estimate until the estimate stays.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/smooth_solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/stop.hpp"
#include "step/time/free_motion.hpp"
#include "step/time/smooth_contacts.hpp"

namespace keyblock {
namespace {

// Increments that change by less than this share of block size are settled: a hundred times round-off of a position.
constexpr double kSettled = 1e-12;
// Usually one to three rounds. A change below kTolerable after the last round is accepted, and the next step closes the
// gap error that it leaves. A larger change is a failure, unless the forces fit the gaps of the last round: a light
// block moves far by what is nothing to a heavy one.
constexpr int kMostRounds = 8;
constexpr int kMostRoundsOfSprings = 30;  // whose law is not linear where they meet or part
constexpr int kMostRoundsOfYield = 40;    // points change sides of their surface from round to round
// Rock that yields is stiff for its strength: a change of strain of this size is a ten-thousandth of the strength where
// that is a hundred-thousandth of the modulus.
constexpr double kTolerableOfYield = 1e-9;
// Shares of the change of the round before: above the first a round does not lead on, below the second it leads far; of
// its part p it promises p, and the third of that is enough. The least part that is taken.
constexpr double kStalls = 0.7;
constexpr double kLeads = 0.25;
constexpr double kPromised = 0.9;
constexpr double kLeastPart = 1.0 / 16;
constexpr double kTolerable = 1e-6;
// Rows and matrix are made anew about the first estimates, and where these moved by more than the second figure:
// directions of forces are then as good as that, and gaps are those of the estimate itself in any case.
constexpr int kMostRows = 2;
constexpr double kSameRows = 1e-9;
// In assemblies rows may be as wrong as forces are, and forces that meet the gaps of the last estimate within this many
// times their goal, a hundred-thousandth of the heaviest load, are not sought again: what is left is a share of that
// size of the free fall of a step.
constexpr double kSameRowsOfMany = 1e-5;
constexpr double kGoalsOfEstimate = 10;
constexpr double kOfLast = 2;
// The matrix of bodies on covers is kept from round to round while a round leaves less than this share of the change
// before.
constexpr double kWorstGain = 0.03;
// Linear systems that a round may make whatever those before it took.
constexpr int kFewestSystems = 8;

/// The parts of rounds that are taken where rock may yield: points that change sides of their surface in turn would go
/// on so. Half as much of a round that changes as much as the one before; twice as much after one that led far, or two
/// that led as far as their part promised.
class PartsOfRounds {
 public:
  /// `left`: the change of a round over that of the one before.
  double next(double left) {
    if (left > kStalls) {
      kept_ = 0;
      return part_ = std::max(part_ / 2, kLeastPart);
    }
    kept_ = left <= 1 - kPromised * part_ ? kept_ + 1 : 0;
    if (left < kLeads || kept_ > 1) {
      kept_ = 0;
      part_ = std::min(1.0, 2 * part_);
    }
    return part_;
  }

 private:
  double part_ = 1;
  int kept_ = 0;  ///< rounds in a row that led as far as promised
};

class SmoothSolve {
 public:
  SmoothSolve(const StandardScene& scene, const Motion& start, const UnknownsTable& loads, const Touches& touches,
              const ForceTolerance& tolerance, double time, double dt, const StepRule& rule, const SmoothMotion* before)
      : tolerance_(tolerance),
        free_(scene, start, loads, rule, dt),
        contacts_(scene, start, touches, tolerance, time, dt, rule, free_) {
    increments_ = is_linear() ? free_.increments() : before ? plus(before->q, -1, start.q) : free_.steady();
    result_.forces = before ? contacts_.forces_of(*before) : contacts_.remembered_forces();
  }

  SmoothMotion run() {
    do {
      settle();
    } while (result_.converged && contacts_.break_bonds(result_.forces));
    static_cast<BodiesMotion&>(result_) = free_.end(increments_, result_.converged);
    std::move(contacts_).put_end(result_);
    result_.flexibility = std::move(free_).take_flexibility();
    return std::move(result_);
  }

 private:
  void settle() {
    contacts_.take_laws();
    result_.converged = true;
    double change = is_linear() ? 0 : 1;
    double unsolved = std::numeric_limits<double>::infinity();
    double before = change;
    PartsOfRounds parts;
    for (int round = 0; round < most_rounds() && change > kSettled && result_.converged; ++round) {
      leave_if_stopped();
      const double same = is_coarse() ? kSameRowsOfMany : kSameRows;
      const bool rows_moved = round > 0 && round < kMostRows && free_.greatest_change(increments_, linearised_) > same;
      const bool falls_slowly = !free_.is_linear() && round > 1 && change > kWorstGain * before;
      if (round == 0 || falls_slowly) result_.converged = free_.linearise(increments_);
      if (!result_.converged) return;
      if (round == 0 || rows_moved || falls_slowly) {
        linearised_ = increments_;
        contacts_.linearise(increments_);
      }
      before = change;
      free_.evaluate(increments_);
      contacts_.set_right_side(increments_);
      Tried now = tried(contacts_.problem(), result_.forces);
      unsolved = residual(contacts_.problem(), now);
      if (round > 0 && !rows_moved && is_good_enough(unsolved)) break;
      UnknownsTable next = next_increments(std::move(now));
      change = free_.greatest_change(increments_, next);
      const double part = free_.has_kinks() ? parts.next(change / before) : 1;
      increments_ = part < 1 ? plus(increments_, part, plus(next, -1, increments_)) : std::move(next);
    }
    // Bodies on covers are not linear: that forces meet the gaps says nothing of their balance.
    const bool forces_suffice = free_.is_linear() && std::isfinite(change) &&
                                unsolved <= std::max(contacts_.problem().acceptable, tolerance_.tolerated);
    const double tolerable = free_.has_kinks() ? kTolerableOfYield : kTolerable;
    result_.converged = result_.converged && (change <= tolerable || forces_suffice);
  }

  // Very many pairs between blocks alone.
  bool is_coarse() const { return free_.is_linear() && contacts_.touch_count() > FrictionalProblem::kVeryManyPairs; }

  // What forces leave of the gaps of the last estimate is nothing to their goal, or no more than they left of those
  // before.
  bool is_good_enough(double unsolved) const {
    return is_coarse() && unsolved <= std::max(kGoalsOfEstimate * contacts_.problem().goal, kOfLast * result_.residual);
  }

  int most_rounds() const {
    if (free_.has_kinks()) return kMostRoundsOfYield;
    return contacts_.springs_stop() ? kMostRoundsOfSprings : kMostRounds;
  }

  bool is_linear() const { return contacts_.is_empty() && free_.is_linear(); }

  UnknownsTable next_increments(Tried now) {
    FrictionalProblem& problem = contacts_.problem();
    problem.most_systems = std::max(kFewestSystems, tolerance_.most_systems - result_.solves);
    problem.enough_systems = std::max(0, tolerance_.enough_systems - result_.solves);
    const FrictionalSolution solution = solve(problem, std::move(now), &contacts_.kept());
    result_.forces = solution.forces;
    result_.solves += solution.solves;
    result_.sweeps += solution.sweeps;
    result_.residual = solution.residual;
    result_.is_tolerated = !solution.converged && solution.residual <= tolerance_.tolerated;
    result_.converged = solution.converged || result_.is_tolerated;
    result_.undecided = solution.undecided;
    return plus(free_.increments(), 1, answer(contacts_.rows(), free_.flexibility(), solution.forces));
  }

  ForceTolerance tolerance_;
  FreeMotion free_;
  SmoothContacts contacts_;
  UnknownsTable increments_;
  UnknownsTable linearised_;  ///< increments about which rows and matrix were made
  SmoothMotion result_;
};

}  // namespace

SmoothMotion smooth_solve(const StandardScene& scene, const Motion& start, const UnknownsTable& loads,
                          const Touches& touches, const ForceTolerance& tolerance, double time, double dt,
                          const StepRule& rule, const SmoothMotion* before) {
  return SmoothSolve(scene, start, loads, touches, tolerance, time, dt, rule, before).run();
}

}  // namespace keyblock
