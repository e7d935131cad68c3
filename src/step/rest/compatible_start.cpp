// Repeats the solution of forces, strains and shifts; each round uses the geometry of the last. See
// compatible_start.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/compatible_start.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>

#include "base/context.hpp"
#include "contact/rows/gap.hpp"
#include "contact/solve/friction_newton.hpp"
#include "step/newton/tolerances.hpp"
#include "step/rest/start_forces.hpp"
#include "step/scene/contact_laws.hpp"
#include "step/scene/step_constraints.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

class CompatibleSettling {
 public:
  CompatibleSettling(const StandardScene& scene, Motion motion)
      : start_(scene, std::move(motion)),
        unshifted_(start_.motion),
        found_(touches_of(scene, start_.motion, start_.scales, scene.settings.time_step)) {}

  CompatibleStart run() {
    if (start_.tolerance == 0) return {std::move(start_.motion), {}};
    do fit();
    while (break_bonds());
    remember();
    const std::string failure = greatest_shift_ > of_compatible_start::kLeverage * asked_ ? too_far() : std::string();
    const double left = misfit();
    return {std::move(start_.motion), failure, left, start_.carrying_bolts()};
  }

 private:
  void fit() {
    for (int round = 0;
         round < of_compatible_start::kStaticRounds ||
         (round < of_compatible_start::kMostRounds && (misfit() > of_compatible_start::kFits || !start_.balances()));
         ++round) {
      // Held points may carry in more ways than one: rigid bodies would choose one by the frame of the drawing.
      const bool by_elasticity = round >= of_compatible_start::kStaticRounds || !start_.scene.held.empty();
      settle(by_elasticity);
      while (stretch_bolts()) settle(by_elasticity);
      tell_headway("start in equilibrium", share_of_fall(1, misfit(), of_compatible_start::kFits));
      add_overlapping();
    }
  }

  // Forces of rigid blocks are one solution of many: the strength of bonds is judged by those of elastic blocks.
  bool break_bonds() {
    if (start_.motion.bonds.empty()) return false;
    start_.make_rows();
    start_.distribute();
    return break_open_bonds() || break_overloaded_faces();
  }

  void settle(bool by_elasticity) {
    do {
      leave_if_stopped();
      start_.make_rows();
      start_.find();
    } while (let_go_of_weak_bolts());
    if (by_elasticity) start_.distribute();
    strain();
    shift();
  }

  // Adds bolts that the loads stretch, if contacts and pretension do not suffice. A bolt whose pretension pulls its
  // ends together does suffice; a constant bolt force never changes.
  bool stretch_bolts() {
    if (start_.scene.model.bolts.empty()) return false;
    const Eigen::VectorXd longer =
        rates(bolt_rows(start_.scene.model, start_.scene.reference, start_.motion.q), start_.acceleration);
    const std::size_t before = start_.bolts.size();
    for (std::size_t i = 0; i < start_.scene.model.bolts.size(); ++i) {
      const bool may_pull = start_.scene.model.bolts[i].is_spring() && !start_.motion.constraints.broken[i] &&
                            !std::ranges::count(start_.bolts, i) && !std::ranges::count(weak_bolts_, i);
      if (may_pull &&
          longer[static_cast<Eigen::Index>(2 * i)] > of_compatible_start::kRoundOff * start_.acceleration_of_loads)
        start_.bolts.push_back(i);
    }
    if (start_.bolts.size() == before) return false;
    start_.elastic.resize(0);
    return true;
  }

  // Removes bolts that would break; their blocks fall into them.
  bool let_go_of_weak_bolts() {
    std::vector<std::size_t> strong;
    for (std::size_t i = 0; i < start_.bolts.size(); ++i)
      (start_.bolt(i).pretension + start_.tension(i) < start_.bolt(i).strength ? strong : weak_bolts_)
          .push_back(start_.bolts[i]);
    if (strong.size() == start_.bolts.size()) return false;
    start_.bolts = std::move(strong);
    start_.elastic.resize(0);
    return true;
  }

  bool break_overloaded_faces() {
    std::vector<ContactLaw> laws;
    for (const Touch& touch : start_.touches) laws.push_back(contact_law(start_.scene, start_.motion.bonds, touch));
    const std::vector<Facing> overloaded =
        overloaded_faces(start_.scene, start_.motion.q, start_.touches, laws, start_.forces, start_.acceptable);
    for (const Facing& facing : overloaded) start_.motion.bonds.erase(facing);
    return !overloaded.empty();
  }

  // A bond breaks if it carries its tensile strength while its faces part by more than round-off of the acceleration.
  bool break_open_bonds() {
    if (start_.motion.bonds.empty()) return false;
    const std::size_t before = start_.motion.bonds.size();
    const Eigen::VectorXd opening = rates(start_.rows, start_.acceleration);
    const double least = of_compatible_start::kRoundOff *
                         rates(start_.rows, start_.product(start_.rigid, start_.loads)).cwiseAbs().maxCoeff();
    for (std::size_t i = 0; i < start_.touches.size(); ++i) {
      const ContactLaw law = start_.law(i);
      if (law.is_bonded && start_.normal(i) <= law.force.least && opening[start_.tangential(i) - 1] > least)
        start_.motion.bonds.erase(start_.touches[i].facing);
    }
    return start_.motion.bonds.size() < before;
  }

  void strain() {
    UnknownsTable forces = plus(start_.loads, 1, answer(start_.rows, {start_.identities()}, start_.forces));
    for (ElementIndex e : indices(forces)) {
      const Body& body = start_.scene.bodies()[e];
      const Eigen::Index strains = body.strain_count();
      if (strains == 0) continue;
      forces[e] += body.initial_stress - body.mass * start_.acceleration[e];
      start_.motion.q[e].tail(strains) = body.stiffness.inverse() * forces[e].tail(strains);
    }
  }

  // Contacts that carry get the gap of their force, and bonds the slip of their spring. Others only must not
  // overlap, or their springs would kick. Blocks wedged among blocks make W almost singular: combinations of pushes
  // could close a gap only by a large shift. The proximal iterations of the solution leave these to elastic contact.
  void shift() {
    const Table<ElementIndex, UnknownBlock> yielding = start_.counted_as(StartForces::kLightest);
    FrictionalProblem problem{
        ContactMatrix(start_.rows, {yielding}), Eigen::VectorXd::Zero(start_.forces.size()), {}, 0, 0, {}};
    const Eigen::VectorXd gaps = start_.gaps_from_wanted();
    problem.b.head(gaps.size()) = gaps;
    for (std::size_t i = 0; i < start_.touches.size(); ++i)
      problem.laws.push_back(start_.law(i).is_bonded ? kHeld : start_.carries(i) ? kBilateral : ForceLaw{});
    start_.add_bolts(problem);
    for (std::size_t i = 0; i < start_.bolts.size(); ++i) {
      if (start_.tension(i) > 0) problem.laws[start_.touches.size() + i] = kBilateral;
      problem.b[start_.bolt_row(i)] = start_.tension(i) / start_.bolt(i).stiffness - start_.elongation(i);
    }
    const double missing = start_.missing();
    problem.laws.insert(problem.laws.end(), start_.scene.held.size(), kHeld);
    const Eigen::VectorXd off = start_.held_offsets();
    problem.b.tail(off.size()) = off;
    if (missing == 0) return;
    problem.goal = problem.acceptable =
        of_compatible_start::kShiftTolerance * missing / problem.w.diagonal().maxCoeff();
    const UnknownsTable by =
        answer(start_.rows, {yielding}, newton(problem, Eigen::VectorXd::Zero(start_.forces.size())).forces);
    start_.motion.q = plus(start_.motion.q, 1, by);
    asked_ += missing;
    for (ElementIndex e : indices(by))
      if (by[e].size() > 0) greatest_shift_ = std::max(greatest_shift_, by[e].head<2>().norm());
  }

  double misfit() const {
    const double left = start_.missing();
    return left > of_compatible_start::kRoundOff * start_.scales.size ? left / asked_ : 0;
  }

  // Strains and shifts may press together corners that no edge faced before.
  void add_overlapping() {
    const auto vertices = vertices_at(start_.scene.model, start_.scene.reference, start_.motion.q);
    unshifted_.closed = closed();
    const Touches fresh = newly_overlapping(start_.scene, unshifted_, vertices, found_, start_.scales);
    if (fresh.empty()) return;
    const auto of_points = static_cast<Eigen::Index>(2 * (start_.bolts.size() + start_.scene.held.size()));
    Eigen::VectorXd grown = Eigen::VectorXd::Zero(start_.forces.size() + static_cast<Eigen::Index>(2 * fresh.size()));
    grown.head(start_.forces.size() - of_points) = start_.forces.head(start_.forces.size() - of_points);
    grown.tail(of_points) = start_.forces.tail(of_points);
    start_.forces = grown;
    start_.elastic.resize(0);
    found_.insert(found_.end(), fresh.begin(), fresh.end());
    start_.touches.insert(start_.touches.end(), fresh.begin(), fresh.end());
  }

  std::string too_far() const {
    return fmt::format(
        "no compatible start was found: blocks would have to shift by {:.3g} to close gaps of {:.3g} in all; choose "
        "start = "
        "sudden",
        greatest_shift_, asked_);
  }

  ClosedContacts closed() const {
    std::vector<ClosedContact> closed;
    for (std::size_t i = 0; i < start_.touches.size(); ++i) {
      if (!start_.carries(i)) continue;
      const ContactLaw law = start_.law(i);
      closed.push_back({start_.touches[i], memory_of(law, start_.normal(i), start_.forces[start_.tangential(i)])});
    }
    return ClosedContacts(std::move(closed));
  }

  void remember() {
    start_.motion.closed = closed();
    put_bolt_forces(start_.scene, start_.motion);
    start_.motion.constraints.point_forces =
        start_.forces.tail(static_cast<Eigen::Index>(2 * start_.scene.held.size()));
  }

  StartForces start_;
  Motion unshifted_;
  Touches found_;
  std::vector<std::size_t> weak_bolts_;  ///< bolts that the loads would break
  double asked_ = 0;                     ///< sum of all gaps that shifts should close
  double greatest_shift_ = 0;            ///< of one block in one round
};

}  // namespace

CompatibleStart compatible(const StandardScene& scene, Motion motion) {
  return CompatibleSettling(scene, std::move(motion)).run();
}

}  // namespace keyblock
