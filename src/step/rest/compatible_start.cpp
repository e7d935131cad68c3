// Three rounds of force, strain and shift: each sees the geometry the last one left.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/compatible_start.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>

#include "base/stop.hpp"
#include "contact/rows/gap.hpp"
#include "contact/rows/ties.hpp"
#include "contact/solve/friction_newton.hpp"
#include "step/scene/contact_laws.hpp"
#include "step/scene/step_ties.hpp"
#include "step/scene/touch_search.hpp"

namespace keyblock {
namespace {

// Three rounds suffice where statics gives the forces; then elasticity does, and each shrinks the misfit several times.
constexpr int kStaticRounds = 3;
constexpr int kMostRounds = 20;
constexpr double kRoundOff = 1e-9;         // share of block size, or of acceleration, that the rounding of files leaves
constexpr double kFits = 1e-9;             // misfit over the gaps that were to be closed
constexpr double kUnbalanced = 1e-6;       // of the greatest acceleration by the loads
constexpr double kShiftTolerance = 1e-13;  // of the gaps to be closed
// A block that shifts by more than this times all gaps together is thrown about, not settled.
constexpr double kLeverage = 10;
constexpr double kForceTolerance = 1e-12;  // of the largest force on a block
constexpr double kLooser = 1e6;            // what counts as solved where the goal is out of reach

// Contact stiffness over the inertia that keeps rigid motion finite while forces are distributed.
constexpr double kLong = 1e3;
// Of the heaviest block: a lighter one is shifted as if it weighed so much.
constexpr double kLightest = 1e-3;
// Weight of the proximal term over the flexibility of a touch, much less than the share of it that is elastic.
constexpr double kRegular = 1e-7;
// Slip given to a sliding touch, over all others, so that it slides on.
constexpr double kBeyond = 1e3;
// A friction force this near to its limit slides.
constexpr double kSliding = 1 - 1e-6;

class Settling {
 public:
  Settling(const StandardScene& scene, Motion motion)
      : scene_(scene),
        motion_(std::move(motion)),
        loads_(loads_at(scene, motion_.q, 0)),
        rigid_(rigid_mass_inverses(scene.bodies)) {
    for (const Unknowns& a : product(rigid_, loads_))
      if (a.size() > 0) acceleration_of_loads_ = std::max(acceleration_of_loads_, a.head<2>().norm());
    const ContactRows of_bolts = bolt_rows(scene.model, scene.reference, motion_.q);
    if (!of_bolts.empty()) loads_ = plus(loads_, 1, answer(of_bolts, {identities()}, pretensions()));
    const Scales scales = scales_of(scene_, loads_, motion_.q, motion_.v);
    add_centrifugal_force(scene_, motion_.v, loads_);
    tolerance_ = kForceTolerance * scales.force;
    for (const Body& body : scene.bodies)
      if (body.mass.rows() > 0) heaviest_ = std::max(heaviest_, body.mass(0, 0));
    touches_ = resting_touches(scene_, motion_, scales);
    scales_ = scales;
    unshifted_ = motion_;
    found_ = touches_of(scene_, motion_, scales, scene.settings.time_step);
  }

  CompatibleStart run() {
    if (tolerance_ == 0) return {std::move(motion_), {}};
    for (int round = 0; round < kStaticRounds || (round < kMostRounds && (misfit() > kFits || !balances())); ++round) {
      settle(round >= kStaticRounds);
      while (break_open_bonds() || stretch_bolts()) settle(round >= kStaticRounds);
      add_overlapping();
    }
    remember();
    const std::string failure = greatest_shift_ > kLeverage * asked_ ? too_far() : std::string();
    const double left = misfit();
    return {std::move(motion_), failure, left, carrying_bolts(), weak_bolts_.empty() && balances()};
  }

 private:
  void settle(bool by_elasticity) {
    do {
      leave_if_stopped();
      make_rows();
      find_forces();
    } while (break_sheared_bonds() || let_go_of_weak_bolts());
    if (by_elasticity) distribute();
    strain();
    shift();
  }

  // Touches, stretched bolts, held points. A bolt pulls as a touch pushes: its rows are turned over.
  void make_rows() {
    rows_ = contact_rows(scene_.model, scene_.reference, motion_.q, touches_);
    if (!bolts_.empty()) {
      ContactRows all = bolt_rows(scene_.model, scene_.reference, motion_.q);
      for (const std::size_t bolt : bolts_) {
        for (ContactRow* row : {&all[2 * bolt], &all[2 * bolt + 1]}) {
          row->of_vertex = -row->of_vertex;
          row->of_edge = -row->of_edge;
          rows_.push_back(*row);
        }
      }
    }
    if (scene_.held.empty()) return;
    const ContactRows of_points = point_rows(scene_.model, scene_.reference, motion_.q, scene_.held);
    rows_.insert(rows_.end(), of_points.begin(), of_points.end());
  }

  // Velocities after one step of free acceleration stand for g̈, so that a block that slides already keeps its
  // direction.
  void find_forces() {
    const double dt = scene_.settings.time_step;
    forces_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows_.size()));
    if (!rows_.empty()) {
      FrictionalProblem problem{ContactMatrix(rows_, {scaled(dt, rigid_)}),
                                dt * rates(rows_, product(rigid_, loads_)),
                                {},
                                tolerance_,
                                kLooser * tolerance_,
                                {}};
      for (const Touch& touch : touches_) problem.laws.push_back(contact_law(scene_, motion_.bonds, touch).force);
      const Eigen::VectorXd v = rates(rows_, motion_.v);
      for (std::size_t i = 0; i < touches_.size(); ++i) problem.b[tangential(i)] += v[tangential(i)];
      add_bolts(problem);
      problem.laws.insert(problem.laws.end(), scene_.held.size(), kHeld);
      if (has_light_blocks())
        problem.scale = diagonal_of(rows_, {scaled(dt, counted_as(1))}, problem.w.covers()) + problem.w.added();
      forces_ = solve(problem, forces_).forces;
    }
    acceleration_ = plus(product(rigid_, loads_), 1, answer(rows_, {rigid_}, forces_));
  }

  // Across a bolt there is no force; the one keeps its row from being singular.
  void add_bolts(FrictionalProblem& problem) const {
    for (std::size_t i = 0; i < bolts_.size(); ++i) {
      problem.laws.push_back({});
      problem.w.add_to_diagonal(bolt_row(i) + 1, 1);
    }
  }

  // Bolts that the loads stretch, where contacts and the pretension do not suffice. A bolt whose pretension pulls its
  // ends together does so; a constant force stays as it is.
  bool stretch_bolts() {
    if (scene_.model.bolts.empty()) return false;
    const Eigen::VectorXd longer = rates(bolt_rows(scene_.model, scene_.reference, motion_.q), acceleration_);
    const std::size_t before = bolts_.size();
    for (std::size_t i = 0; i < scene_.model.bolts.size(); ++i) {
      const bool may_pull = scene_.model.bolts[i].is_spring() && !motion_.ties.broken[i] &&
                            !std::ranges::count(bolts_, i) && !std::ranges::count(weak_bolts_, i);
      if (may_pull && longer[static_cast<Eigen::Index>(2 * i)] > kRoundOff * acceleration_of_loads_)
        bolts_.push_back(i);
    }
    if (bolts_.size() == before) return false;
    elastic_.resize(0);
    return true;
  }

  // Those that would break stay as they are: their blocks fall into them.
  bool let_go_of_weak_bolts() {
    std::vector<std::size_t> strong;
    for (std::size_t i = 0; i < bolts_.size(); ++i)
      (bolt(i).pretension + tension(i) < bolt(i).strength ? strong : weak_bolts_).push_back(bolts_[i]);
    if (strong.size() == bolts_.size()) return false;
    bolts_ = std::move(strong);
    elastic_.resize(0);
    return true;
  }

  bool break_sheared_bonds() {
    std::vector<ContactLaw> laws;
    for (const Touch& touch : touches_) laws.push_back(contact_law(scene_, motion_.bonds, touch));
    const std::vector<Facing> sheared = sheared_bonds(touches_, laws, forces_, kLooser * tolerance_);
    for (const Facing& facing : sheared) motion_.bonds.erase(facing);
    return !sheared.empty();
  }

  // A bond that carries its tensile strength while its faces part: once more than round-off of the acceleration.
  bool break_open_bonds() {
    if (motion_.bonds.empty()) return false;
    const std::size_t before = motion_.bonds.size();
    const Eigen::VectorXd opening = rates(rows_, acceleration_);
    const double least = kRoundOff * rates(rows_, product(rigid_, loads_)).cwiseAbs().maxCoeff();
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      const ContactLaw law = contact_law(scene_, motion_.bonds, touches_[i]);
      if (law.is_bonded && normal(i) <= law.force.least && opening[tangential(i) - 1] > least)
        motion_.bonds.erase(touches_[i].facing);
    }
    return motion_.bonds.size() < before;
  }

  // Forces of rigid blocks are not unique where more touches carry than statics needs. Those of elastic blocks are: the
  // ones under which blocks loaded by f − M a strain and shift until the gaps are met (inertia relief), sliding touches
  // sliding on. Rigid motion is kept finite by a mass over a long time squared.
  void distribute() {
    if (rows_.empty()) return;
    double softest = scene_.normal_stiffness();
    for (std::size_t i = 0; i < bolts_.size(); ++i) softest = std::min(softest, bolt(i).stiffness);
    Table<ElementIndex, UnknownBlock> flexibility;
    UnknownsTable increments;
    for (ElementIndex e : indices(scene_.bodies)) {
      const Body& body = scene_.bodies[e];
      const UnknownBlock a = body.sum_of(softest / (kLong * heaviest_), 1);
      flexibility.push_back(a.rows() > 0 ? UnknownBlock(a.llt().solve(UnknownBlock::Identity(a.rows(), a.cols()))) : a);
      const Unknowns unbalanced =
          loads_[e] + body.initial_stress - body.elastic_force(motion_.q[e]) - body.mass * acceleration_[e];
      increments.push_back(flexibility[e] * unbalanced);
    }
    FrictionalProblem problem{
        ContactMatrix(rows_, {flexibility}), rates(rows_, increments), {}, tolerance_, kLooser * tolerance_, {}};
    const auto vertices = vertices_at(scene_.model, scene_.reference, motion_.q);
    const double beyond = kBeyond * problem.b.cwiseAbs().maxCoeff() +
                          kBeyond * problem.w.diagonal().maxCoeff() * forces_.cwiseAbs().maxCoeff();
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      const ContactLaw law = contact_law(scene_, motion_.bonds, touches_[i]);
      const Eigen::Index n = tangential(i) - 1;
      problem.laws.push_back(law.force);
      problem.w.add_to_diagonal(n, law.normal_compliance);
      problem.w.add_to_diagonal(n + 1, law.tangential_compliance);
      problem.b[n] += gap_of(touches_[i], vertices) - law.rest_gap;
      const double force = forces_[n + 1];
      if (std::abs(force) > 0 && std::abs(force) >= kSliding * law.force.limit(normal(i)))
        problem.b[n + 1] = force > 0 ? -beyond : beyond;
    }
    add_bolts(problem);
    for (std::size_t i = 0; i < bolts_.size(); ++i) {
      problem.w.add_to_diagonal(bolt_row(i), 1 / bolt(i).stiffness);
      problem.b[bolt_row(i)] -= elongation(i);
    }
    problem.laws.insert(problem.laws.end(), scene_.held.size(), kHeld);
    problem.proximal = kRegular * problem.w.diagonal();
    problem.acceptable = tolerance_;
    FrictionalSolution elastic = newton(problem, elastic_.size() > 0 ? elastic_ : forces_);
    elastic.converged = elastic.residual <= kLooser * tolerance_;
    if (elastic.converged) elastic_ = forces_ = elastic.forces;
  }

  void strain() {
    UnknownsTable forces = plus(loads_, 1, answer(rows_, {identities()}, forces_));
    for (ElementIndex e : indices(forces)) {
      const Body& body = scene_.bodies[e];
      const Eigen::Index strains = body.strain_count();
      if (strains == 0) continue;
      forces[e] += body.initial_stress - body.mass * acceleration_[e];
      motion_.q[e].tail(strains) = body.stiffness.inverse() * forces[e].tail(strains);
    }
  }

  // Touches that carry get the gap of their force; the others are only kept from overlapping, or their springs would
  // kick. Blocks wedged among blocks make W all but singular; the proximal rounds of the solution leave combinations of
  // pushes that would close a gap by a large shift only to the elastic contact.
  void shift() {
    const Table<ElementIndex, UnknownBlock> yielding = counted_as(kLightest);
    FrictionalProblem problem{ContactMatrix(rows_, {yielding}), Eigen::VectorXd::Zero(forces_.size()), {}, 0, 0, {}};
    const std::vector<double> gaps = gaps_from_wanted();
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      problem.laws.push_back(normal(i) != 0 ? kTie : ForceLaw{});
      problem.b[static_cast<Eigen::Index>(2 * i)] = gaps[i];
    }
    add_bolts(problem);
    for (std::size_t i = 0; i < bolts_.size(); ++i) {
      if (tension(i) > 0) problem.laws[touches_.size() + i] = kTie;
      problem.b[bolt_row(i)] = tension(i) / bolt(i).stiffness - elongation(i);
    }
    double missing = this->missing();
    problem.laws.insert(problem.laws.end(), scene_.held.size(), kHeld);
    if (!scene_.held.empty()) {
      const Eigen::VectorXd off = offsets(scene_.model, scene_.reference, motion_.q, scene_.held, 0);
      problem.b.tail(off.size()) = off;
      missing += off.cwiseAbs().sum();
    }
    if (missing == 0) return;
    problem.goal = problem.acceptable = kShiftTolerance * missing / problem.w.diagonal().maxCoeff();
    const UnknownsTable by = answer(rows_, {yielding}, newton(problem, Eigen::VectorXd::Zero(forces_.size())).forces);
    motion_.q = plus(motion_.q, 1, by);
    asked_ += missing;
    for (ElementIndex e : indices(by))
      if (by[e].size() > 0) greatest_shift_ = std::max(greatest_shift_, by[e].head<2>().norm());
  }

  // Beside what a block of a millionth of their mass yields, what two heavy blocks do to each other is round-off. Which
  // of two a shift moves is open, and by which of them a force is judged: light ones count as a share of the heaviest.
  Table<ElementIndex, UnknownBlock> counted_as(double share) const {
    Table<ElementIndex, UnknownBlock> blocks = rigid_;
    for (ElementIndex e : indices(blocks))
      if (blocks[e].rows() > 0) blocks[e] *= std::min(1.0, scene_.bodies[e].mass(0, 0) / (share * heaviest_));
    return blocks;
  }
  bool has_light_blocks() const {
    return std::ranges::any_of(scene_.bodies, [&](const Body& body) {
      return body.mass.rows() > 0 && body.mass(0, 0) < kLightest * heaviest_;
    });
  }

  // Gaps, counted from those that the forces want.
  std::vector<double> gaps_from_wanted() const {
    const auto vertices = vertices_at(scene_.model, scene_.reference, motion_.q);
    std::vector<double> gaps;
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      const ContactLaw law = contact_law(scene_, motion_.bonds, touches_[i]);
      gaps.push_back(gap_of(touches_[i], vertices) - law.rest_gap + normal(i) * law.normal_compliance);
    }
    return gaps;
  }
  double missing() const {
    const std::vector<double> gaps = gaps_from_wanted();
    double sum = 0;
    for (std::size_t i = 0; i < gaps.size(); ++i) sum += normal(i) != 0 ? std::abs(gaps[i]) : std::max(0.0, -gaps[i]);
    for (std::size_t i = 0; i < bolts_.size(); ++i)
      if (tension(i) > 0) sum += std::abs(elongation(i) - tension(i) / bolt(i).stiffness);
    return sum;
  }

  // Whether forces that elasticity distributed still give the accelerations, where bolts are among them: contacts have
  // their gaps for that.
  bool balances() const {
    if (bolts_.empty()) return true;
    const UnknownsTable made = plus(product(rigid_, loads_), 1, answer(rows_, {rigid_}, forces_));
    for (ElementIndex e : indices(made))
      if (made[e].size() > 0 && (made[e] - acceleration_[e]).head<2>().norm() > kUnbalanced * acceleration_of_loads_)
        return false;
    return true;
  }

  double misfit() const {
    const double left = missing();
    return left > kRoundOff * scales_.size ? left / asked_ : 0;
  }

  // Corners where no edge led, and that strains and shifts have pressed together.
  void add_overlapping() {
    const auto vertices = vertices_at(scene_.model, scene_.reference, motion_.q);
    const Touches fresh = newly_overlapping(scene_, unshifted_, vertices, found_, scales_);
    if (fresh.empty()) return;
    const auto of_points = static_cast<Eigen::Index>(2 * (bolts_.size() + scene_.held.size()));
    Eigen::VectorXd grown = Eigen::VectorXd::Zero(forces_.size() + static_cast<Eigen::Index>(2 * fresh.size()));
    grown.head(forces_.size() - of_points) = forces_.head(forces_.size() - of_points);
    grown.tail(of_points) = forces_.tail(of_points);
    forces_ = grown;
    elastic_.resize(0);
    found_.touches.insert(found_.touches.end(), fresh.begin(), fresh.end());
    touches_.insert(touches_.end(), fresh.begin(), fresh.end());
  }

  std::string too_far() const {
    return fmt::format(
        "no compatible start was found: blocks would have to shift by {:.3g} to close gaps of {:.3g} in all; choose "
        "start = "
        "sudden",
        greatest_shift_, asked_);
  }

  void remember() {
    std::vector<ClosedContact> closed;
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      if (normal(i) == 0) continue;
      const ContactLaw law = contact_law(scene_, motion_.bonds, touches_[i]);
      closed.push_back({touches_[i], memory_of(law, normal(i), forces_[tangential(i)])});
    }
    motion_.closed = ClosedContacts(std::move(closed));
    const Eigen::VectorXd longer = elongations(scene_.model, scene_.reference, motion_.q);
    for (std::size_t i = 0; i < scene_.model.bolts.size(); ++i) {
      const Bolt& bolt = scene_.model.bolts[i];
      if (bolt.is_spring() && !motion_.ties.broken[i])
        motion_.ties.bolt_forces[i] = bolt.pretension + bolt.stiffness * longer[static_cast<Eigen::Index>(i)];
    }
    motion_.ties.point_forces = forces_.tail(static_cast<Eigen::Index>(2 * scene_.held.size()));
  }

  // Force λ = −f along the rows of each bolt, none across.
  Eigen::VectorXd pretensions() const {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * scene_.model.bolts.size()));
    for (std::size_t i = 0; i < scene_.model.bolts.size(); ++i)
      if (scene_.model.bolts[i].is_spring())
        forces[static_cast<Eigen::Index>(2 * i)] = -scene_.model.bolts[i].pretension;
    return forces;
  }

  static Eigen::Index tangential(std::size_t touch) { return static_cast<Eigen::Index>(2 * touch + 1); }
  double normal(std::size_t touch) const { return forces_[static_cast<Eigen::Index>(2 * touch)]; }
  Eigen::Index bolt_row(std::size_t i) const { return static_cast<Eigen::Index>(2 * (touches_.size() + i)); }
  const Bolt& bolt(std::size_t i) const { return scene_.model.bolts[bolts_[i]]; }
  double tension(std::size_t i) const { return forces_[bolt_row(i)]; }  ///< beyond the pretension
  double elongation(std::size_t i) const {
    return elongations(scene_.model, scene_.reference, motion_.q)[static_cast<Eigen::Index>(bolts_[i])];
  }
  int carrying_bolts() const {
    int count = 0;
    for (std::size_t i = 0; i < bolts_.size(); ++i) count += tension(i) > 0 ? 1 : 0;
    return count;
  }

  Table<ElementIndex, UnknownBlock> identities() const {
    Table<ElementIndex, UnknownBlock> all = rigid_;
    for (UnknownBlock& block : all) block.setIdentity();
    return all;
  }
  static Table<ElementIndex, UnknownBlock> scaled(double by, Table<ElementIndex, UnknownBlock> blocks) {
    for (UnknownBlock& block : blocks) block *= by;
    return blocks;
  }
  static UnknownsTable product(const Table<ElementIndex, UnknownBlock>& blocks, const UnknownsTable& x) {
    UnknownsTable result = x;
    for (ElementIndex e : indices(x)) result[e] = blocks[e] * x[e];
    return result;
  }

  const StandardScene& scene_;
  Motion motion_;
  UnknownsTable loads_;
  Table<ElementIndex, UnknownBlock> rigid_;
  Touches touches_;
  std::vector<std::size_t> bolts_;       ///< stretched by the loads
  std::vector<std::size_t> weak_bolts_;  ///< that the loads would break
  double acceleration_of_loads_ = 0;     ///< greatest, without pretensions
  FoundTouches found_;
  Motion unshifted_;
  Scales scales_;
  double tolerance_ = 0;
  double heaviest_ = 0;
  ContactRows rows_;
  Eigen::VectorXd forces_;
  Eigen::VectorXd elastic_;  ///< forces of the last round that elasticity distributed
  UnknownsTable acceleration_;
  double asked_ = 0;           ///< sum of all gaps that shifts were to close
  double greatest_shift_ = 0;  ///< of one block in one round
};

}  // namespace

CompatibleStart compatible(const StandardScene& scene, Motion motion) {
  return Settling(scene, std::move(motion)).run();
}

}  // namespace keyblock
