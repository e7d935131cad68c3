// Relinearises gaps and rows about the last estimate until the estimate stays.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/smooth_solve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "base/loop.hpp"
#include "base/stop.hpp"
#include "base/worse.hpp"
#include "contact/rows/gap.hpp"
#include "contact/solve/active_forces.hpp"
#include "step/bodies/step_equations.hpp"
#include "step/scene/contact_laws.hpp"
#include "step/scene/step_ties.hpp"

namespace keyblock {
namespace {

// Increments that change by less than this share of block size are settled: a hundred times round-off of a position.
constexpr double kSettled = 1e-12;
// Usually one to three rounds. A change below kTolerable after the last round is accepted, and the next step closes the
// gap error that it leaves. A larger change is a failure, unless the forces fit the gaps of the last round: a light
// block moves far by what is nothing to a heavy one.
constexpr int kMostRounds = 8;
constexpr int kMostRoundsOfSprings = 30;  // whose law is not linear where they meet or part
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
// Gaps of this share of block size need not be closed further by forces without springs.
constexpr double kGapTolerance = 1e-9;
// Where nothing loads a scene, no load says what forces are small: round-off is these shares of what the gaps ask for
// one by one.
constexpr double kRoundOff = 1e-14;
constexpr double kFewRoundOffs = 1e-12;
// Linear systems that a round may make whatever those before it took.
constexpr int kFewestSystems = 8;
// A bond that opens by more than this share of block size in a step is broken; less is round-off of the solution.
constexpr double kBroken = 1e-11;

class SmoothSolve {
 public:
  SmoothSolve(const StandardScene& scene, const Motion& start, const UnknownsTable& loads, const Touches& touches,
              const ForceTolerance& tolerance, double time, double dt, const StepRule& rule, const SmoothMotion* before)
      : scene_(scene),
        start_(start),
        touches_(touches),
        tolerance_(tolerance),
        dt_(dt),
        rule_(rule),
        start_vertices_(vertices_at(scene.model, scene.reference, start.q)),
        bonds_(start.bonds),
        ties_(scene, start, time, dt, rule.stiffness) {
    prepare_blocks(loads);
    if (scene.covers) prepare_covers(loads.covers);
    increments_ = is_linear() ? free_ : before ? plus(before->q, -1, start.q) : steady();
    for (const Body& body : scene.bodies)
      if (body.mass.rows() > 0) size_ = std::max(size_, body.size);
    if (scene.covers) size_ = std::max(size_, scene.covers->size());
    remember_contacts();
    result_.forces = before ? forces_of(*before) : remembered_forces();
  }

  SmoothMotion run() {
    do {
      settle();
    } while (result_.converged && break_bonds());
    result_.q = plus(start_.q, 1, increments_);
    result_.v = plus(known_velocity_, rate(), increments_);
    result_.a = plus(known_acceleration_, rule_.end_acceleration.increment, increments_);
    if (covers_ && result_.converged) {
      CoverMotion end = covers_->end(increments_.covers);
      result_.v.covers = std::move(end.v);
      result_.a.covers = std::move(end.a);
    }
    result_.bonds = bonds_;
    result_.ties = ties_.memory(result_.forces.tail(result_.forces.size() - first_tie()), result_.q);
    for (std::size_t i = 0; i < touches_.size(); ++i) result_.rate_laws.push_back(follows_rate(i));
    if (rows_) result_.rows = std::move(*rows_);  // the matrix that shares them is not used again
    result_.laws = std::move(laws_);
    result_.flexibility = std::move(inverse_);
    return std::move(result_);
  }

 private:
  void settle() {
    laws_.clear();
    for (const Touch& touch : touches_) laws_.push_back(contact_law(scene_, bonds_, touch));
    result_.converged = true;
    double change = is_linear() ? 0 : 1;
    double unsolved = std::numeric_limits<double>::infinity();
    double before = change;
    for (int round = 0; round < most_rounds() && change > kSettled && result_.converged; ++round) {
      leave_if_stopped();
      const double same = is_coarse() ? kSameRowsOfMany : kSameRows;
      const bool rows_moved = round > 0 && round < kMostRows && greatest_change(increments_, linearised_) > same;
      const bool falls_slowly = covers_ != nullptr && round > 1 && change > kWorstGain * before;
      if (round == 0 || falls_slowly) refactor_covers();
      if (!result_.converged) return;
      if (round == 0 || rows_moved || falls_slowly) linearise();
      before = change;
      if (covers_) {
        covers_->evaluate(increments_.covers);
        free_.covers = covers_->free_increment();
      }
      set_right_side(increments_);
      Tried now = tried(problem_, result_.forces);
      unsolved = residual(problem_, now);
      if (round > 0 && !rows_moved && is_good_enough(unsolved)) break;
      UnknownsTable next = next_increments(std::move(now));
      change = greatest_change(increments_, next);
      increments_ = std::move(next);
    }
    // Bodies on covers are not linear: that forces meet the gaps says nothing of their balance.
    const bool forces_suffice =
        !covers_ && std::isfinite(change) && unsolved <= std::max(problem_.acceptable, tolerance_.tolerated);
    result_.converged = result_.converged && (change <= kTolerable || forces_suffice);
  }

  void prepare_blocks(const UnknownsTable& loads) {
    const std::size_t count = scene_.bodies.size();
    inverse_.blocks.resize(count);
    if (rule_.judging_inertia > 0) judging_.blocks.resize(count);
    for (UnknownsTable* table : {&free_, &known_velocity_, &known_acceleration_}) table->resize(count);
    for_each_entry(count, [&](std::size_t i) { prepare({static_cast<int>(i)}, loads); });
  }
  void prepare(ElementIndex e, const UnknownsTable& loads) {
    StepEquations equations =
        step_equations(scene_.bodies[e], {start_.q[e], start_.v[e], start_.a[e]}, loads[e], rule_);
    inverse_.blocks[e] = std::move(equations.inverse);
    if (!judging_.blocks.empty()) judging_.blocks[e] = std::move(equations.judging);
    free_[e] = std::move(equations.free);
    known_velocity_[e] = std::move(equations.known_velocity);
    known_acceleration_[e] = std::move(equations.known_acceleration);
  }

  void prepare_covers(const Eigen::VectorXd& load) {
    covers_ = &scene_.covers->equations();
    covers_->begin({start_.q.covers, start_.v.covers, start_.a.covers}, load, rule_, dt_);
    known_velocity_.covers = covers_->known_velocity();
    known_acceleration_.covers = covers_->known_acceleration();
  }

  // Very many pairs between blocks alone.
  bool is_coarse() const { return !covers_ && touches_.size() > FrictionalProblem::kVeryManyPairs; }

  // What forces leave of the gaps of the last estimate is nothing to their goal, or no more than they left of those
  // before.
  bool is_good_enough(double unsolved) const {
    return is_coarse() && unsolved <= std::max(kGoalsOfEstimate * problem_.goal, kOfLast * result_.residual);
  }

  int most_rounds() const { return springs_stop() ? kMostRoundsOfSprings : kMostRounds; }

  // Blocks by themselves are: strain is measured in their own frame.
  bool is_linear() const { return touches_.empty() && ties_.count() == 0 && !scene_.covers; }

  static UnknownsTable scaled(UnknownsTable x, double by) {
    x *= by;
    return x;
  }

  // Slip velocities are counted as increments: the displacement that alone would give them.
  double rate() const { return rule_.end_velocity.increment; }

  // Increments of a motion that goes on as it is: at rest none.
  UnknownsTable steady() const { return scaled(plus(start_.v, -1, known_velocity_), 1 / rate()); }

  // A body on covers that buckles, or turns inside out, has no factor; in a shorter step it may have one.
  void refactor_covers() {
    if (!covers_) return;
    try {
      covers_->linearise(increments_.covers);
    } catch (const NotPositiveDefinite&) {
      result_.converged = false;
    }
    inverse_.covers = scene_.covers->flexibility_of_step();
    if (!judging_.blocks.empty()) judging_.covers = inverse_.covers;
  }

  void linearise() {
    kept_ = {};
    line_compliance_.resize(0);
    linearised_ = increments_;
    const UnknownsTable middle = plus(start_.q, 0.5, increments_);
    rows_ = std::make_shared<ContactRows>(contact_rows(scene_.model, scene_.reference, middle, touches_));
    const ContactRows of_ties = ties_.rows(middle);
    rows_->insert(rows_->end(), of_ties.begin(), of_ties.end());
    problem_.w = ContactMatrix(rows_, inverse_);
    const bool all_sprung = std::ranges::all_of(laws_, [](const ContactLaw& law) { return law.normal_compliance > 0; });
    problem_.gap_tolerance = all_sprung ? 0 : kGapTolerance * size_;
    if (!judging_.blocks.empty()) problem_.scale = diagonal_of(*rows_, judging_, problem_.w.covers());
    problem_.laws.clear();
    problem_.proximal = Eigen::VectorXd::Zero(has_proximal() ? problem_.w.rows() : 0);
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      const auto n = static_cast<Eigen::Index>(2 * i);
      const ContactLaw& law = laws_[i];
      problem_.laws.push_back(law.force);
      add_compliance(n, normal_scale(i) * law.normal_compliance);
      add_compliance(n + 1, of_stretch() * law.tangential_compliance);
      if (problem_.proximal.size() == 0) continue;
      problem_.proximal[n] = law.normal_weight;
      problem_.proximal[n + 1] = of_stretch() * law.tangential_weight;
    }
    for (std::size_t i = 0; i < ties_.count(); ++i) {
      const Eigen::Index n = first_tie() + static_cast<Eigen::Index>(2 * i);
      problem_.laws.push_back(ties_.law(i));
      add_compliance(n, ties_.compliance(i));
      if (i < ties_.bolt_count()) add_compliance(n + 1, 1);  // across a bolt there is no force
    }
  }
  void add_compliance(Eigen::Index row, double compliance) {
    problem_.w.add_to_diagonal(row, compliance);
    if (problem_.scale.size() > 0) problem_.scale[row] += compliance;
  }
  Eigen::Index first_tie() const { return static_cast<Eigen::Index>(2 * touches_.size()); }
  // An augmented Lagrangian says its own.
  bool has_proximal() const {
    const auto is_augmented = [](const ContactLaw& law) { return law.normal_weight > 0; };
    return std::ranges::any_of(laws_, is_augmented) && std::ranges::all_of(laws_, [&](const ContactLaw& law) {
             return is_augmented(law) || law.normal_compliance > 0;
           });
  }

  UnknownsTable next_increments(Tried now) {
    problem_.most_systems = std::max(kFewestSystems, tolerance_.most_systems - result_.solves);
    problem_.enough_systems = std::max(0, tolerance_.enough_systems - result_.solves);
    const FrictionalSolution solution = solve(problem_, std::move(now), &kept_);
    result_.forces = solution.forces;
    result_.solves += solution.solves;
    result_.sweeps += solution.sweeps;
    result_.residual = solution.residual;
    result_.is_tolerated = !solution.converged && solution.residual <= tolerance_.tolerated;
    result_.converged = solution.converged || result_.is_tolerated;
    result_.undecided = solution.undecided;
    return plus(free_, 1, answer(*rows_, inverse_, solution.forces));
  }

  void set_right_side(const UnknownsTable& estimate) {
    const Table<VertexIndex, Point> end = vertices_at(scene_.model, scene_.reference, plus(start_.q, 1, estimate));
    const Eigen::VectorXd from_estimate = rates(*rows_, plus(free_, -1, estimate));
    Eigen::VectorXd line_compliance = Eigen::VectorXd::Zero(springs_stop() ? first_tie() : 0);
    problem_.b = rates(*rows_, plus(free_, 1 / rate(), known_velocity_));
    for_each_entry(touches_.size(), [&](std::size_t i) {
      const auto n = static_cast<Eigen::Index>(2 * i);
      const double before = gap_of(touches_[i], start_vertices_) - laws_[i].rest_gap;
      const double after = gap_of(touches_[i], end) - laws_[i].rest_gap;
      if (follows_rate(i))
        problem_.b[n] += of_stretch() * before;
      else
        problem_.b[n] = after + from_estimate[n];
      if (springs_stop() && laws_[i].normal_compliance > 0) {
        const SpringLine line = spring_line(before, after, laws_[i].normal_compliance);
        problem_.b[n] -= line.rest;
        line_compliance[n] = line.compliance;
      }
      const ContactMemory* memory = memories_[i];
      if (memory && laws_[i].tangential_compliance > 0) problem_.b[n + 1] += of_stretch() * memory->stretch;
    });
    follow_lines(line_compliance);
    const Eigen::Index of_ties = problem_.b.size() - first_tie();
    problem_.b.tail(of_ties) = ties_.gaps(plus(start_.q, 1, estimate)) + from_estimate.tail(of_ties);
    problem_.goal = tolerance_.goal;
    problem_.acceptable = tolerance_.acceptable;
    if (tolerance_.acceptable > 0 || problem_.b.size() == 0) return;
    const double asked = problem_.b.cwiseQuotient(problem_.compliance()).cwiseAbs().maxCoeff();
    problem_.goal = kRoundOff * asked;
    problem_.acceptable = kFewRoundOffs * asked;
  }

  // Springs that stop an impact give back what they took, whatever the step: their force is the change of their energy
  // U = p min(g, 0)²/2 over that of the gap, λ = −(U(g1) − U(g0)) / (g1 − g0) (Gonzalez 2000): the mean of both ends
  // while they are pressed. Where they meet or part within the step it is not linear in g1, and each round takes its
  // tangent at the last estimate.
  bool springs_stop() const { return scene_.settings.standard.impact == ImpactLaw::springs; }
  double normal_scale(std::size_t i) const { return springs_stop() ? 0 : follows_rate(i) ? of_stretch() : 1; }

  // λ = (rest − g1) / compliance.
  struct SpringLine {
    double rest = 0;
    double compliance = 0;
  };
  static SpringLine spring_line(double before, double after, double compliance) {
    if (before <= 0 && after <= 0) return {-before, 2 * compliance};
    const double way = std::abs(after - before);
    if (before > 0 && after >= 0)
      return {-way, 2 * compliance};  // no force unless the estimate turns out to be far off
    const double pressed = std::min(before, after);
    const double force = pressed * pressed / (2 * compliance * way);
    const double slope = after < before ? -pressed / (compliance * way) * (1 + pressed / (2 * way)) : force / way;
    return {after + force / slope, 1 / slope};
  }

  void follow_lines(const Eigen::VectorXd& compliance) {
    if (compliance.size() == 0) return;
    if (line_compliance_.size() != compliance.size()) line_compliance_ = Eigen::VectorXd::Zero(compliance.size());
    for (Eigen::Index n = 0; n < compliance.size(); n += 2) {
      if (compliance[n] == line_compliance_[n]) continue;
      add_compliance(n, compliance[n] - line_compliance_[n]);
      kept_ = {};
    }
    line_compliance_ = compliance;
  }

  // A spring that was closed before is compressed by dt times the velocity at the end of the step, λ = −p (g0 + dt ġ1),
  // as the tangential one is stretched: where it is too stiff for the step, the gap at its end would leave its rate
  // turned over in every step for ever.
  bool follows_rate(std::size_t i) const {
    const bool is_step = !rule_.carries_acceleration() && rule_.judging_inertia == 0;
    return is_step && !springs_stop() && memories_[i] && laws_[i].normal_compliance > 0;
  }

  // The tangential spring is stretched by dt times the velocity at the end of the step: a spring too stiff for the step
  // then brings its point to rest, where the displacement of the step would turn the velocity over in each step.
  double of_stretch() const { return 1 / (rate() * dt_); }

  // A bond that opens is gone, one that carries all it can without moving, because its neighbour holds, stays. Where
  // none opens, faces sheared beyond their strength lose all theirs; contacts go on without cohesion (brittle joint).
  bool break_bonds() {
    const std::size_t before = bonds_.size();
    const NaturalMap map = natural_map(problem_, result_.forces);
    const Eigen::VectorXd y = problem_.w * result_.forces + problem_.b;
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      if (!laws_[i].is_bonded || !is_open(map.grips[i])) continue;
      if (y[static_cast<Eigen::Index>(2 * i)] > kBroken * size_) bonds_.erase(touches_[i].facing);
    }
    if (bonds_.size() == before)
      for (const Facing& facing : sheared_bonds(touches_, laws_, result_.forces, problem_.acceptable))
        bonds_.erase(facing);
    return bonds_.size() < before;
  }

  void remember_contacts() {
    memories_.resize(touches_.size());
    for_each_entry(touches_.size(), [&](std::size_t i) { memories_[i] = start_.closed.of(touches_[i]); });
  }

  Eigen::VectorXd remembered_forces() const {
    const Eigen::VectorXd of_ties = ties_.remembered();
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(first_tie() + of_ties.size());
    forces.tail(of_ties.size()) = of_ties;
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      const ContactMemory* memory = memories_[i];
      if (!memory) continue;
      forces[static_cast<Eigen::Index>(2 * i)] = memory->normal;
      forces[static_cast<Eigen::Index>(2 * i + 1)] = memory->tangential;
    }
    return forces;
  }

  // Ties come last in both.
  Eigen::VectorXd forces_of(const SmoothMotion& before) const {
    assert(before.laws.size() <= touches_.size());
    const auto known = static_cast<Eigen::Index>(2 * before.laws.size());
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(first_tie() + before.forces.size() - known);
    forces.head(known) = before.forces.head(known);
    forces.tail(before.forces.size() - known) = before.forces.tail(before.forces.size() - known);
    return forces;
  }

  // Relative to block size; rotation and strain are relative as they are.
  double greatest_change(const UnknownsTable& a, const UnknownsTable& b) const {
    double greatest = 0;
    for (ElementIndex e : indices(a)) {
      if (a[e].size() == 0) continue;
      const Unknowns change = (a[e] - b[e]).cwiseAbs();
      greatest = worse(greatest, change.head<2>().maxCoeff<Eigen::PropagateNaN>() / scene_.bodies[e].size);
      greatest = worse(greatest, change.tail(change.size() - 2).maxCoeff<Eigen::PropagateNaN>());
    }
    if (a.covers.size() > 0)
      greatest =
          worse(greatest, (a.covers - b.covers).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() / scene_.covers->size());
    return greatest;
  }

  const StandardScene& scene_;
  const Motion& start_;
  const Touches& touches_;
  ForceTolerance tolerance_;
  double dt_;
  StepRule rule_;
  Table<VertexIndex, Point> start_vertices_;
  Bonds bonds_;
  StepTies ties_;
  std::vector<ContactLaw> laws_;
  std::vector<const ContactMemory*> memories_;  ///< of each touch; none of one that was open
  std::shared_ptr<ContactRows> rows_;
  FrictionalProblem problem_;
  Eigen::VectorXd line_compliance_;  ///< of springs that stop impacts, as the matrix has it
  KeptSystem kept_;                  ///< of `problem_` and its rows
  UnknownsTable increments_;
  UnknownsTable linearised_;          ///< increments about which rows and matrix were made
  double size_ = 0;                   ///< of the largest moving block
  CoverEquations* covers_ = nullptr;  ///< of this step; none without bodies on covers
  Flexibility inverse_;
  Flexibility judging_;               ///< inverses by which forces are judged, where these are others
  UnknownsTable free_;                ///< increments without contact
  UnknownsTable known_velocity_;      ///< what the increments leave of the velocities at the end
  UnknownsTable known_acceleration_;  ///< the same of the accelerations
  SmoothMotion result_;
};

}  // namespace

SmoothMotion smooth_solve(const StandardScene& scene, const Motion& start, const UnknownsTable& loads,
                          const Touches& touches, const ForceTolerance& tolerance, double time, double dt,
                          const StepRule& rule, const SmoothMotion* before) {
  return SmoothSolve(scene, start, loads, touches, tolerance, time, dt, rule, before).run();
}

}  // namespace keyblock
