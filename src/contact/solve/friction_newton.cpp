// Iterates over active sets within each proximal round.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solve/friction_newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/context.hpp"
#include "contact/solve/active_forces.hpp"

namespace keyblock {
namespace {

// Weight of the proximal term over the compliance of a force, in the first round with such a term. Small weights need
// few rounds but diverge on jointed masses, where larger ones follow. Weights change by a factor of ten per round.
constexpr double kFirstWeight = 1e-3;
constexpr double kTen = 10;
// Limits of the weight. A softer round makes almost no progress; a sharper one is singular on jointed masses. W_ii
// between a light and a heavy block is that of the light one. A fraction of it may exceed the compliance of the heavy
// one. Few pairs therefore go on to kSharpestOfFew.
constexpr double kSoftest = 1;
constexpr double kSharpest = 1e-6;
constexpr double kSharpestOfFew = 1e-8;
// Fixed points have no springs and do not open. This weight makes them regular; one round leaves less error than a
// fixed block strains.
constexpr double kOfHeld = 1e-8;
// A round converges to this fraction of its initial residual: the remaining proximal term is larger.
constexpr double kOfRound = 1e-3;
// A weight is kept if a round reduces the residual to this fraction or less.
constexpr double kGood = 0.1;
// An acceptable residual is final if a round leaves more than this fraction of it.
constexpr double kProgress = 0.5;
// Limits of rounds, and of active sets per round. With many pairs a longer round has diverged.
constexpr int kMostRounds = 40;
constexpr int kMostSets = 60;
constexpr int kMostSetsOfMany = 16;
// Line search towards the forces of an active set, for springs. A step suffices if it reduces the residual by
// kSufficient of its length. It is halved at most kHalvingsOfWay times. The search gives up after kMostRises active
// sets in a row without a reduction.
constexpr double kSufficient = 0.1;
constexpr int kHalvingsOfWay = 8;
constexpr int kMostRises = 2;
// From this set on, a proximal round of many pairs counts as diverged if more pairs change than half of those at first,
// and more than kStillFew.
constexpr int kSetsToSettle = 4;
constexpr std::size_t kStillFew = 20;
// Few forces stay as they are if their residual is below this fraction of the goal.
constexpr double kOfGoal = 1e-3;
// A pair slides if its way, as a force, is more than this many acceptable residuals. A pair holds if its residual is
// below kOfOwn of its own force: what is little for a large block may throw a small one.
constexpr double kSlides = 100;
constexpr double kOfOwn = 1e-4;
// Residual that iterations may leave, over the goal. kForcing: over the initial residual of an active set that need not
// be the last.
constexpr double kInner = 0.3;
constexpr double kForcing = 0.001;

// A pair sticks at first if its tangential force is below this fraction of its limit; rounding stays far from it.
constexpr double kWithinStrength = 1 - 1e-9;

class Newton {
 public:
  Newton(const FrictionalProblem& problem, FrictionalSolution so_far, KeptSystem& kept, Tried first)
      : problem_(problem),
        solution_(std::move(so_far)),
        kept_(kept),
        base_(base_weights()),
        is_unique_(has_unique_forces(problem)),
        nothing_opens_(nothing_opens()),
        tried_(std::move(first)) {}

  FrictionalSolution run() {
    if (is_left_as_is()) return std::move(solution_);
    if (tried_.forces.size() == 0) tried_ = tried(problem_, solution_.forces);
    gaps_ = tried_.y;
    double weight = is_unique_ ? 0 : 1;
    double softest_lost = 0;
    for (int round = 0; round < kMostRounds; ++round) {
      const double before = solution_.residual;
      const Eigen::VectorXd reference = solution_.forces;
      if (tried_.forces != reference) tried_ = tried(problem_, reference);
      const bool settled = settle({weights_of(weight), reference});
      const double gain = solution_.residual / before;
      // If nothing can open, the factorisation stays valid, and the last digits cost one solve each.
      const bool refines = nothing_opens_ && gain < kProgress && solution_.residual > kOfGoal * problem_.goal;
      if (is_solved() && !refines) break;
      const bool are_few = !problem_.has_many();
      if (!settled || gain >= 1) {
        // With many contacts, a detour through the interior finds the states better than a larger weight does.
        const bool goes_on = are_few ? !solution_.converged : nothing_opens_;
        if (is_unique_ || !goes_on || weight >= kSoftest / kFirstWeight) break;
        softest_lost = weight;
        weight *= kTen;
        continue;
      }
      if (solution_.converged && gain > kProgress && weight <= sharpest()) break;
      // Few forces that need a large motion to change keep the first weight, unless only digits are missing.
      const bool is_far = are_few && !solution_.converged;
      if (!is_unique_ && gain > kGood && !is_far && weight / kTen > softest_lost)
        weight = std::max(weight / kTen, sharpest());
    }
    return std::move(solution_);
  }

 private:
  // Solves with the proximal term. Returns false if the active sets cycle, diverge or leave forces undetermined.
  bool settle(const Proximal& proximal) {
    const Eigen::VectorXd right = problem_.b - proximal.weights.cwiseProduct(proximal.reference);
    const double goal = std::max(kInner * problem_.goal, kOfRound * solution_.residual);
    std::vector<std::vector<Grip>> visited;  // since the last partial step
    NaturalMap map = natural_map(problem_, tried_, proximal);
    if (is_unique_ && problem_.is_static()) keep_sticking(map.grips);
    std::size_t first_changes = 0;
    int rises = 0;
    bool was_solved = is_solved();
    bool is_loose = true;
    const int most = problem_.has_many() ? kMostSetsOfMany : kMostSets;
    for (int i = 0; i < most; ++i) {
      begin_system();
      const std::vector<Grip> grips = std::move(map.grips);
      visited.push_back(grips);
      factorise(grips, proximal.weights);
      const bool is_rough = is_loose && system().iterates();
      const double left = is_rough ? kForcing * residual(problem_, tried_) : 0;
      auto forces = system().solve(right, tried_.forces, std::max(kInner * problem_.goal, left));
      if (!forces) return false;
      const double before = merit(map);
      const bool is_whole = go_towards(tried(problem_, *std::move(forces)), before, proximal);
      keep_best();
      if (is_solved() && (is_whole || was_solved)) return true;
      was_solved = is_solved();
      map = natural_map(problem_, tried_, proximal);
      const std::size_t changes = different(grips, map.grips);
      if (is_whole && changes == 0 && !is_rough) return true;
      if (!is_rough && change(map) <= goal) return true;
      rises = merit(map) < before ? 0 : rises + 1;
      if (i == 0) first_changes = changes;
      const bool is_late = problem_.has_many() && i + 1 >= kSetsToSettle;
      if (is_unique_ ? problem_.has_many() && rises >= kMostRises
                     : is_late && changes > std::max(first_changes / 2, kStillFew))
        return false;
      if (is_whole && std::ranges::find(visited, map.grips) == visited.end()) continue;
      if (is_whole && !is_rough) return false;
      if (is_whole) is_loose = false;  // errors of iterations may be the cause of the cycle
      visited.clear();
    }
    return false;
  }

  // Returns the residual of the natural map: its largest change of the forces tried.
  double change(const NaturalMap& map) const { return largest(problem_, map.forces - tried_.forces); }

  // Returns the residual that a line search reduces. In statics of very many pairs it is the energy of the change: the
  // largest change belongs to one pair, which would shorten the steps of all others.
  double merit(const NaturalMap& map) const {
    if (!problem_.is_static() || !problem_.has_very_many()) return change(map);
    return std::sqrt((map.forces - tried_.forces).cwiseAbs2().dot(problem_.compliance()));
  }

  // The first active set of statics holds every pair whose force is within its strength, as the elastic predictor of
  // plasticity does. The natural map lets each pair answer the whole load alone, and so may find a state in which all
  // slip although they stick together.
  void keep_sticking(std::vector<Grip>& grips) const {
    for (std::size_t i = 0; i < problem_.count(); ++i) {
      const auto n = static_cast<Eigen::Index>(2 * i);
      const bool bears = tried_.forces[n] > problem_.laws[i].least;
      if (bears && std::abs(tried_.forces[n + 1]) < kWithinStrength * problem_.laws[i].limit(tried_.forces[n]))
        grips[i] = Grip::stick;
    }
  }

  // Moves to the forces of an active set. Under springs, which make normal forces unique, it halves the step until the
  // residual has fallen enough. Otherwise it takes the step with the smallest residual: Newton's method for a map with
  // kinks (Pang 1990). Friction may still have several solutions; short steps end at the nearest one.
  bool go_towards(Tried full, double before, const Proximal& proximal) {
    if (!is_unique_) {
      tried_ = std::move(full);
      return true;
    }
    const Tried from = std::move(tried_);
    Tried best = full;
    double best_part = 1;
    double least = std::numeric_limits<double>::infinity();
    for (double part = 1; part >= std::exp2(-kHalvingsOfWay); part /= 2) {
      tried_ = {from.forces + part * (full.forces - from.forces), from.y + part * (full.y - from.y)};
      const double left = merit(natural_map(problem_, tried_, proximal));
      if (left < least) {
        least = left;
        best_part = part;
        best = part == 1 ? full : tried_;
      }
      if (least <= (1 - kSufficient * best_part) * before) break;
    }
    tried_ = std::move(best);
    return best_part == 1;
  }

  // Returns the weights of the problem. A force with neither weight nor compliance gets the default weight.
  Eigen::VectorXd base_weights() const {
    const Eigen::VectorXd ours = kFirstWeight * problem_.compliance();
    if (problem_.proximal.size() == 0) return ours;
    Eigen::VectorXd weights = problem_.proximal;
    for (Eigen::Index i = 0; i < weights.size(); ++i)
      if (weights[i] + problem_.w.added()[i] == 0) weights[i] = ours[i];
    return weights;
  }

  bool nothing_opens() const {
    return std::ranges::none_of(problem_.laws, [](const ForceLaw& law) { return law.can_open(); });
  }

  bool has_spring(std::size_t row) const { return problem_.w.added()[static_cast<Eigen::Index>(row)] > 0; }
  Eigen::VectorXd weights_of(double weight) const {
    Eigen::VectorXd weights = weight * base_;
    if (is_unique_)
      for (Eigen::Index i = 0; i < weights.size(); ++i)
        if (!has_spring(static_cast<std::size_t>(i))) weights[i] = kOfHeld * problem_.compliance()[i];
    return weights;
  }
  double sharpest() const { return is_unique_ ? 0 : (problem_.has_many() ? kSharpest : kSharpestOfFew) / kFirstWeight; }

  ActiveForces& system() { return *kept_.system; }

  void factorise(const std::vector<Grip>& grips, const Eigen::VectorXd& weights) {
    if (kept_.system && grips == kept_.grips && weights == kept_.weights) return;
    kept_.system.reset();  // its factorisation is reused
    kept_ = {std::make_unique<ActiveForces>(problem_, grips, weights), grips, weights};
    ++solution_.solves;
  }

  // A system of few pairs costs almost nothing. A gap left within the goal of its force would be closed in a later
  // step, with a velocity that strains stiff blocks. After a detour with many springs, one active set refines the
  // forces to the last digits. Without it a nanometre of noise affects the motion of a slope.
  bool is_left_as_is() const {
    const bool is_enough = problem_.has_many() && !(is_unique_ && solution_.solves > 0);
    return solution_.residual <= (is_enough ? 1 : kOfGoal) * problem_.goal;
  }
  bool is_solved() const { return solution_.residual <= problem_.goal; }

  void keep_best() {
    const double now = residual(problem_, tried_);
    if (!(now < solution_.residual)) return;
    const bool is_good = is_acceptable(problem_, tried_);
    if (solution_.converged && (!is_good || is_worse())) return;
    solution_.residual = now;
    gaps_ = tried_.y;
    solution_.forces = tried_.forces;
    solution_.converged = is_good;
  }

  // Few pairs whose forces hold all of them do not exchange these for forces under which one slides.
  bool is_worse() const {
    return !is_unique_ && holds(problem_, {solution_.forces, gaps_}) && !holds(problem_, tried_);
  }

  static std::size_t different(const std::vector<Grip>& a, const std::vector<Grip>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
    return count;
  }

  const FrictionalProblem& problem_;
  FrictionalSolution solution_;  ///< with the best forces found
  KeptSystem& kept_;
  Eigen::VectorXd base_;  ///< weights of the first proximal round
  bool is_unique_;        ///< springs determine the forces
  bool nothing_opens_;
  Tried tried_;           ///< forces of the last active set
  Eigen::VectorXd gaps_;  ///< y of the best forces
};

}  // namespace

bool holds(const FrictionalProblem& problem, const Tried& tried) {
  if (problem.has_many() || problem.is_static() || problem.proximal.size() > 0) return false;
  const Eigen::VectorXd change = (natural_map(problem, tried).forces - tried.forces).cwiseAbs();
  for (std::size_t i = 0; i < problem.count(); ++i) {
    const auto n = static_cast<Eigen::Index>(2 * i);
    const double share = problem.share_of(n);
    if (change.segment<2>(n).maxCoeff() > std::max(kOfOwn * std::abs(tried.forces[n]), share * problem.goal))
      return false;
    const double way = std::abs(tried.y[n + 1]) / problem.compliance()[n + 1];
    if (tried.forces[n] > problem.laws[i].least && way > kSlides * share * problem.acceptable) return false;
  }
  return true;
}

bool has_unique_forces(const FrictionalProblem& problem) {
  bool has_contact = false;
  for (std::size_t i = 0; i < problem.count(); ++i) {
    if (!problem.laws[i].can_open()) continue;
    has_contact = true;
    const auto n = static_cast<Eigen::Index>(2 * i);
    if (!(problem.w.added()[n] > 0 && problem.w.added()[n + 1] > 0)) return false;
  }
  return has_contact;
}

FrictionalSolution newton(const FrictionalProblem& problem, const Eigen::VectorXd& start) {
  Tried first = tried(problem, start);
  FrictionalSolution so_far{start, residual(problem, first), 0, 0, is_acceptable(problem, first), {}};
  return newton(problem, std::move(so_far), nullptr, std::move(first));
}

FrictionalSolution newton(const FrictionalProblem& problem, FrictionalSolution so_far, KeptSystem* kept, Tried first) {
  KeptSystem own;
  return Newton(problem, std::move(so_far), kept ? *kept : own, std::move(first)).run();
}

}  // namespace keyblock
