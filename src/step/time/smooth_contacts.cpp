// Sets up the contact problem: gaps at the end of the step, directions at its middle.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/smooth_contacts.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "base/loop.hpp"
#include "contact/rows/gap.hpp"
#include "step/newton/tolerances.hpp"
#include "step/scene/contact_laws.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

// Linearised spring: λ = (rest − g1) / compliance.
struct SpringLine {
  double rest = 0;
  double compliance = 0;
};

// Smallest compression relative to the change of gap. Below it, the neglected force is less than 1e-12 of the force
// that would close the change. The line would be so soft that the matrix would lose digits.
constexpr double kNotPressed = 1e-6;

// Springs that stop an impact conserve its energy at any step size. Their force is the change of the energy U = p
// min(g, 0)²/2 over that of the gap (Gonzalez 2000):
//     λ = −(U(g1) − U(g0)) / (g1 − g0).
// This is the mean of both ends while they are pressed. If they close or open within the step, λ is not linear in g1,
// and each iteration takes the tangent at the last estimate.
SpringLine spring_line(double before, double after, double compliance) {
  if (before <= 0 && after <= 0) return {-before, 2 * compliance};
  const double way = std::abs(after - before);
  const double pressed = std::min(before, after);
  if (-pressed <= kNotPressed * way) return {-way, 2 * compliance};  // no force unless the estimate is far off
  const double force = pressed * pressed / (2 * compliance * way);
  const double slope = after < before ? -pressed / (compliance * way) * (1 + pressed / (2 * way)) : force / way;
  return {after + force / slope, 1 / slope};
}

}  // namespace

SmoothContacts::SmoothContacts(const StandardScene& scene, const Motion& start, const Touches& touches,
                               const ForceTolerance& tolerance, double time, double dt, const StepRule& rule,
                               const FreeMotion& free)
    : scene_(scene),
      start_(start),
      touches_(touches),
      free_(free),
      tolerance_(tolerance),
      dt_(dt),
      may_follow_rates_(!rule.carries_acceleration() && rule.judging_inertia == 0),
      bonds_(start.bonds),
      constraints_(scene, start, time, dt, rule.stiffness) {
  const Table<VertexIndex, Point> vertices = vertices_at(scene.model, scene.reference, start.q);
  memories_.resize(touches_.size());
  start_gaps_.resize(touches_.size());
  for_each_entry(touches_.size(), [&](std::size_t i) {
    memories_[i] = start_.closed.of(touches_[i]);
    start_gaps_[i] = gap_of(touches_[i], vertices);
  });
  for (const Touch& touch : touches_)
    follows_way_.push_back(may_follow_rates_ && !springs_stop() && resolves_impact(scene, touch));
  if (!is_empty()) greatest_before_ = remembered_forces().cwiseAbs().maxCoeff();
}

void SmoothContacts::take_laws() {
  laws_.clear();
  for (const Touch& touch : touches_) laws_.push_back(contact_law(scene_, bonds_, touch));
}

void SmoothContacts::linearise(const UnknownsTable& estimate) {
  kept_ = {};
  line_compliance_.resize(0);
  const UnknownsTable middle = plus(start_.q, 0.5, estimate);
  rows_ = std::make_shared<ContactRows>(contact_rows(scene_.model, scene_.reference, middle, touches_));
  const ContactRows of_constraints = constraints_.rows(middle);
  rows_->insert(rows_->end(), of_constraints.begin(), of_constraints.end());
  problem_.w = ContactMatrix(rows_, free_.flexibility(), scene_.factors);
  const bool all_sprung = std::ranges::all_of(laws_, [](const ContactLaw& law) { return law.normal_compliance > 0; });
  problem_.gap_tolerance = all_sprung ? 0 : of_gaps::kGapTolerance * free_.size();
  if (free_.has_judging()) problem_.scale = diagonal_of(*rows_, free_.judging(), problem_.w.shared());
  add_laws();
  put_shares();
}

void SmoothContacts::put_shares() {
  if (tolerance_.shares.empty()) return;
  problem_.share.resize(problem_.w.rows());
  for (Eigen::Index force = 0; force < problem_.w.rows(); ++force) {
    const ContactRow& row = (*rows_)[static_cast<std::size_t>(force)];
    problem_.share[force] = tolerance_.share_of(row.vertex_element, row.edge_element);
  }
}

void SmoothContacts::add_laws() {
  problem_.laws.clear();
  problem_.proximal = Eigen::VectorXd::Zero(has_proximal() ? problem_.w.rows() : 0);
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    const auto n = static_cast<Eigen::Index>(2 * i);
    const ContactLaw& law = laws_[i];
    problem_.laws.push_back(law.force);
    add_compliance(n, normal_scale(i) * law.normal_compliance);
    add_compliance(n + 1, tangential_scale(i) * law.tangential_compliance);
    if (problem_.proximal.size() == 0) continue;
    problem_.proximal[n] = law.normal_weight;
    problem_.proximal[n + 1] = tangential_scale(i) * law.tangential_weight;
  }
  for (std::size_t i = 0; i < constraints_.count(); ++i) {
    const Eigen::Index n = first_constraint() + static_cast<Eigen::Index>(2 * i);
    problem_.laws.push_back(constraints_.law(i));
    add_compliance(n, constraints_.compliance(i));
    if (i < constraints_.bolt_count()) add_compliance(n + 1, 1);  // no force acts across a bolt
  }
}

void SmoothContacts::add_compliance(Eigen::Index row, double compliance) {
  problem_.w.add_to_diagonal(row, compliance);
  if (problem_.scale.size() > 0) problem_.scale[row] += compliance;
}

// An augmented Lagrangian defines its own proximal term.
bool SmoothContacts::has_proximal() const {
  const auto is_augmented = [](const ContactLaw& law) { return law.normal_weight > 0; };
  return std::ranges::any_of(laws_, is_augmented) && std::ranges::all_of(laws_, [&](const ContactLaw& law) {
           return is_augmented(law) || law.normal_compliance > 0;
         });
}

void SmoothContacts::set_right_side(const UnknownsTable& estimate) {
  const Table<VertexIndex, Point> end = vertices_at(scene_.model, scene_.reference, plus(start_.q, 1, estimate));
  const Eigen::VectorXd from_estimate = rates(*rows_, plus(free_.increments(), -1, estimate));
  Eigen::VectorXd line_compliance = Eigen::VectorXd::Zero(springs_stop() ? first_constraint() : 0);
  problem_.b = rates(*rows_, plus(free_.increments(), 1 / free_.rate(), free_.known_velocity()));
  const Eigen::VectorXd way = rates(*rows_, free_.increments());
  for_each_entry(touches_.size(), [&](std::size_t i) {
    const auto n = static_cast<Eigen::Index>(2 * i);
    const ContactMemory* memory = memories_[i];
    const double before = start_gaps_[i] - laws_[i].rest_gap;
    const double after = gap_of(touches_[i], end) - laws_[i].rest_gap;
    if (follows_rate(i))
      problem_.b[n] += of_stretch() * memory->counted(before, dt_);
    else
      problem_.b[n] = after + from_estimate[n];
    if (springs_stop() && laws_[i].normal_compliance > 0) {
      const SpringLine line = spring_line(before, after, laws_[i].normal_compliance);
      problem_.b[n] -= line.rest;
      line_compliance[n] = line.compliance;
    }
    if (follows_way_[i]) problem_.b[n + 1] = way[n + 1];
    if (memory && laws_[i].tangential_compliance > 0) problem_.b[n + 1] += tangential_scale(i) * memory->stretch;
  });
  follow_lines(line_compliance);
  const Eigen::Index of_constraints = problem_.b.size() - first_constraint();
  problem_.b.tail(of_constraints) = constraints_.gaps(plus(start_.q, 1, estimate)) + from_estimate.tail(of_constraints);
  put_goal();
}

void SmoothContacts::put_goal() {
  double forces = greatest_before_;
  if (tolerance_.acceptable <= 0 && problem_.b.size() > 0)
    forces = std::max(forces, problem_.b.cwiseQuotient(problem_.compliance()).cwiseAbs().maxCoeff());
  problem_.goal = std::max(tolerance_.goal, of_gaps::kRoundOff * forces);
  problem_.acceptable = std::max(tolerance_.acceptable, of_gaps::kFewRoundOffs * forces);
  // Iterations of nonlinear bodies end by their change. If acceptable forces are far from their goal, the remainder on
  // open contacts is not round-off. Cutting it off in each iteration, each time at other contacts, would keep a light
  // piece moving.
  if (!free_.is_linear()) problem_.no_force = problem_.goal;
}

void SmoothContacts::follow_lines(const Eigen::VectorXd& compliance) {
  if (compliance.size() == 0) return;
  if (line_compliance_.size() != compliance.size()) line_compliance_ = Eigen::VectorXd::Zero(compliance.size());
  for (Eigen::Index n = 0; n < compliance.size(); n += 2) {
    if (compliance[n] == line_compliance_[n]) continue;
    add_compliance(n, compliance[n] - line_compliance_[n]);
    kept_ = {};
  }
  line_compliance_ = compliance;
}

// A spring that was closed before is compressed by dt times the end velocity, λ = −p (g0 + dt ġ1), as the tangential
// one is stretched. If it is too stiff for the step, a law in the end gap would reverse its rate in every step for
// ever.
bool SmoothContacts::follows_rate(std::size_t i) const {
  return may_follow_rates_ && !springs_stop() && memories_[i] && laws_[i].normal_compliance > 0;
}

std::vector<Facing> SmoothContacts::overloaded_bonds(const Eigen::VectorXd& forces) const {
  if (bonds_.empty()) return {};
  const Tried now = tried(problem_, forces);
  const NaturalMap map = natural_map(problem_, now);
  std::vector<Facing> open;
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    if (!laws_[i].is_bonded || !is_open(map.grips[i])) continue;
    if (now.y[static_cast<Eigen::Index>(2 * i)] > of_gaps::kBroken * free_.size()) open.push_back(touches_[i].facing);
  }
  return open.empty() ? overloaded_faces(scene_, start_.q, touches_, laws_, forces, problem_.acceptable) : open;
}

bool SmoothContacts::break_bonds(const Eigen::VectorXd& forces) {
  const std::vector<Facing> overloaded = overloaded_bonds(forces);
  for (const Facing& facing : overloaded) bonds_.erase(facing);
  return !overloaded.empty();
}

Eigen::VectorXd SmoothContacts::remembered_forces() const {
  const Eigen::VectorXd of_constraints = constraints_.remembered();
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(first_constraint() + of_constraints.size());
  forces.tail(of_constraints.size()) = of_constraints;
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    const ContactMemory* memory = memories_[i];
    if (!memory) continue;
    forces[static_cast<Eigen::Index>(2 * i)] = memory->normal;
    forces[static_cast<Eigen::Index>(2 * i + 1)] = memory->tangential;
  }
  return forces;
}

// Constraints come last in both.
Eigen::VectorXd SmoothContacts::forces_of(const SmoothMotion& before) const {
  assert(before.laws.size() <= touches_.size());
  const auto known = static_cast<Eigen::Index>(2 * before.laws.size());
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(first_constraint() + before.forces.size() - known);
  forces.head(known) = before.forces.head(known);
  forces.tail(before.forces.size() - known) = before.forces.tail(before.forces.size() - known);
  return forces;
}

void SmoothContacts::put_end(SmoothMotion& to) && {
  to.bonds = std::move(bonds_);
  to.constraints = constraints_.memory(to.forces.tail(to.forces.size() - first_constraint()), to.q);
  for (std::size_t i = 0; i < touches_.size(); ++i) to.rate_laws.push_back(follows_rate(i));
  to.way_laws = std::move(follows_way_);
  if (rows_) to.rows = std::move(*rows_);  // the matrix that shares them is not used again
  to.laws = std::move(laws_);
}

}  // namespace keyblock
