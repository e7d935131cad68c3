// Computes the initial state by the chosen rule, then makes steps of the given size.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/standard_stepper.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/context.hpp"
#include "base/decimals.hpp"
#include "base/sentences/sentences.hpp"
#include "contact/rows/constraints.hpp"
#include "result/describe.hpp"
#include "step/describe_memory.hpp"
#include "step/initial_motion.hpp"
#include "step/lots.hpp"
#include "step/scene/acceleration.hpp"
#include "step/scene/carry_motion.hpp"
#include "step/scene/contact_frames.hpp"
#include "step/scene/equilibrium.hpp"
#include "step/step_outcome.hpp"
#include "step/time/ledger.hpp"

namespace keyblock {
namespace {

struct First : InitialMotion {
  std::optional<ElementIndex> turned = {};  ///< turned inside out by the initial state
};

// Loads that press a block through itself have no initial state; such a run ends with the scene as drawn.
First first_motion(const StandardScene& scene) {
  InitialMotion made = initial_motion(scene);
  const std::optional<ElementIndex> bad = impossible(state_of(scene, made.motion));
  if (!made.failure.empty() || !bad) return {std::move(made)};
  return {{{}, sentence_of({"no_start", {{}, {{"block", part_name(scene, *bad)}}}}), {}}, bad};
}

ControlledStep whole(const StandardScene& scene, const UnknownsTable& from, StandardStep step, double dt) {
  const double displacement =
      step.converged && step.failure.empty() ? greatest_displacement(scene, from, step.motion.q) : 0;
  const double least = step.least > 0 ? step.least : dt;
  return {std::move(step), dt, least, displacement};
}

std::vector<PointState> carried(const StandardScene& scene, const Motion& motion,
                                const std::vector<CarriedPoint>& points) {
  std::vector<PointState> states;
  for (const CarriedPoint& point : points) {
    const Point now = point_at(scene.model, scene.reference, motion.q, point.element, point.start);
    states.push_back({now, now - point.start});
  }
  return states;
}

ElementState element_state(const StandardScene& scene, const Motion& motion, const Table<VertexIndex, Point>& vertices,
                           ElementIndex e) {
  return scene.groups.of(e).state_of(scene.parts(), e, motion, place(scene.model, vertices, e, scene.settings));
}

// Returns the places of state_of without stresses and velocities. NMM elements share a basis: their vertices place
// them.
StartPlaces places_at(const StandardScene& scene, const Motion& motion) {
  StartPlaces places{vertices_at(scene.model, scene.reference, motion.q), {}};
  places.elements.reserve(scene.model.elements.size());
  for (ElementIndex e : indices(scene.model.elements)) {
    if (scene.groups.of(e).shared_basis() != nullptr) {
      const Placement placed = place(scene.model, places.vertices, e, scene.settings);
      places.elements.push_back({placed.centroid, placed.moments});
    } else {
      const ElementState state = element_state(scene, motion, places.vertices, e);
      places.elements.push_back({state.centroid, state.moments});
    }
  }
  return places;
}

std::optional<CoverDisplacement> displacement_of(const StandardScene& scene, const Motion& motion) {
  for (const auto& group : scene.groups)
    if (const CoverBasis* basis = group->shared_basis()) {
      const bool is_in_time = scene.settings.standard.motion == MotionRule::dynamic;
      return CoverDisplacement{*basis, motion.q.shared, true, is_in_time ? &motion.a.shared : nullptr};
    }
  return std::nullopt;
}

// Reports an element that is impossible at the end of a step.
Finding turned_inside_out(const StandardScene& scene, ElementIndex e, const State& before, const State& end) {
  const Point at = before.elements[e].centroid;
  Facts facts{{}, {{"block", part_name(scene, e)}}, {scene.model.number_of(e)}, {{{at.x, at.y}}}};
  const bool is_in_time = scene.settings.standard.motion == MotionRule::dynamic;
  if (!is_in_time && scene.groups.of(e).shared_basis() != nullptr) facts.texts.emplace_back("may_buckle", "");
  const bool softens = add_crushed_before(scene, state_of(scene, start_motion(scene)), before, end, facts);
  return {softens ? "turned_inside_out:softened" : "turned_inside_out", std::move(facts)};
}

StepFailure failure_of_start(const StandardScene& scene, const std::string& why,
                             const std::optional<ElementIndex>& turned) {
  StepFailure failure{why, {}};
  failure.cause.form = "no_start";
  if (turned) {
    failure.kind = FailureKind::inside_out;
    failure.elements = {*turned};
    failure.cause.facts.elements = {scene.model.number_of(*turned)};
  }
  return failure;
}

}  // namespace

State state_of(const StandardScene& scene, const Motion& motion) {
  State state;
  state.vertices = vertices_at(scene.model, scene.reference, motion.q);
  state.elements.reserve(scene.model.elements.size());
  for (ElementIndex e : indices(scene.model.elements))
    state.elements.push_back(element_state(scene, motion, state.vertices, e));
  state.fixed_points = carried(scene, motion, scene.model.fixed_points);
  state.loading_points = carried(scene, motion, scene.model.loading_points);
  state.measured_points = carried(scene, motion, scene.model.measured_points);
  for (std::size_t i = 0; i < scene.model.bolts.size(); ++i) {
    const Bolt& bolt = scene.model.bolts[i];
    const auto end = [&](const MaterialPoint& point) {
      return point_at(scene.model, scene.reference, motion.q, point.element, point.start);
    };
    state.bolts.push_back(
        {end(bolt.first), end(bolt.second), motion.constraints.bolt_forces[i], motion.constraints.broken[i]});
  }
  return state;
}

StandardStepper::StandardStepper(Scene scene) : scene_(standard_scene(std::move(scene))) {
  const std::string why = unsupported(scene_);
  if (!why.empty()) throw std::invalid_argument(why);
  unloaded_ = places_at(scene_, start_motion(scene_));
  First first = first_motion(scene_);
  start_report_ = std::move(first.report);
  start_failure_ = std::move(first.failure);
  turned_at_start_ = first.turned;
  motion_ = start_failure_.empty() ? std::move(first.motion) : start_motion(scene_);
  motion_.a = balanced_acceleration(scene_, motion_, 0);
  state_ = state_of(scene_, motion_);
  if (scene_.settings.ledger == Bookkeeping::on) ledger_ = ledger_row(scene_, motion_);
}

StandardStepper::StandardStepper(const StandardStepper& before, const SceneChange& change, std::vector<FacePull> pulls)
    : scene_(standard_scene(installed(change.scene.model, change.map, before.scene_, before.motion_),
                            change.scene.settings, change.scene.groundwork)),
      motion_(carried_motion(before.scene_, before.motion_, change.map, scene_, before.state_.time)),
      next_part_(before.next_part_),
      begins_scene_(true),
      start_report_(before.start_report_),
      start_failure_(before.start_failure_),
      plastic_work_(before.plastic_work_) {
  const std::string why = unsupported(scene_);
  if (!why.empty()) throw std::invalid_argument(why);
  scene_.pulls = std::move(pulls);
  scene_.mass_centre = before.scene_.mass_centre;
  scene_.load_share = before.scene_.load_share;
  unloaded_ = places_at(scene_, start_motion(scene_));
  motion_.a = balanced_acceleration(scene_, motion_, before.state_.time);
  state_ = state_of(scene_, motion_);
  state_.step = before.state_.step;
  state_.time = before.state_.time;
  state_.dt = before.state_.dt;
  if (scene_.settings.ledger == Bookkeeping::on) book_change(before.ledger_);
}

StandardStepper::StandardStepper(Scene scene, Archive& saved)
    : scene_(standard_scene(std::move(scene))), motion_(start_motion(scene_)) {
  unloaded_ = places_at(scene_, motion_);
  describe(saved);
}

// Besides the motion, only the step number and times need saving: the rest of the state follows from the motion.
void StandardStepper::describe(Archive& archive) {
  archive.group("installed", [&] { describe_installed(archive); });
  archive.value("begins_scene", begins_scene_);
  keyblock::describe(archive, motion_, scene_.model.vertices.end_index());
  if (archive.is_restoring()) state_ = state_of(scene_, motion_);
  archive.value("step", state_.step);
  archive.value("time", state_.time);
  archive.value("dt", state_.dt);
  archive.value("next_part", next_part_);
  archive.value("load_share", scene_.load_share);
  archive.value("start_failure", start_failure_);
  archive.group("start", [&] {
    archive.value("made", start_report_.made);
    archive.value("balanced", start_report_.balanced);
    archive.value("why", start_report_.why);
    archive.value("misfit", start_report_.misfit);
    archive.value("unsolved_steps", start_report_.unsolved_steps);
    archive.value("unbalanced", start_report_.unbalanced);
  });
  archive.group("ledger", [&] { keyblock::describe(archive, ledger_); });
  archive.value("plastic_work", plastic_work_);
}

// Saves data that only the motion of an earlier scene provided.
void StandardStepper::describe_installed(Archive& archive) {
  for (CarriedPoint& point : scene_.model.fixed_points) {
    if (!point.holds_in_place) continue;
    if (archive.is_restoring()) point.curve = {{0}, {Point{}}, {}};
    archive.value("held_x", point.curve.values.front().x);
    archive.value("held_y", point.curve.values.front().y);
  }
  for (Bolt& bolt : scene_.model.bolts) archive.value("pretension", bolt.pretension);
  archive.value("centre_x", scene_.mass_centre.x);
  archive.value("centre_y", scene_.mass_centre.y);
  if (archive.is_restoring()) scene_.held = held_pairs(scene_.model);
}

// Stored energy and momentum jump with the change of scene; flows continue from `before`.
void StandardStepper::book_change(const LedgerRow& before) {
  ledger_ = ledger_row(scene_, motion_);
  ledger_.step = before.step;
  ledger_.time = before.time;
  ledger_.flow = before.flow;
  ledger_.flow.change += ledger_.stored.total() - before.stored.total();
  ledger_.impulse = before.impulse;
  ledger_.impulse +=
      {ledger_.momentum.linear - before.momentum.linear, ledger_.momentum.angular - before.momentum.angular};
}

std::unique_ptr<SceneStepper> StandardStepper::in_next(const SceneChange& change) const {
  return std::make_unique<StandardStepper>(*this, change);
}

bool StandardStepper::is_at_rest(double share) const {
  if (scene_.load_share != 1 || balance_of(scene_, motion_, state_.time).share > share) return false;
  if (scene_.settings.standard.motion != MotionRule::dynamic) return true;
  const Scales scales = scales_at(scene_, motion_, state_.time);
  const double slow = share * std::sqrt(scales.acceleration * scales.size);
  return std::ranges::all_of(state_.elements, [&](const ElementState& element) {
    const double own = element.velocity.size() > 0 ? element.velocity.head<2>().norm() : 0;
    return own + std::hypot(element.carried.x, element.carried.y) <= slow;
  });
}

std::optional<CoverDisplacement> StandardStepper::on_covers() const {
  return displacement_of(scene_, motion_);
}

Stress StandardStepper::stress_at(ElementIndex e, Point start) const {
  return scene_.groups.of(e).stress_at(scene_.parts(), e, motion_, start);
}

std::optional<PlasticState> StandardStepper::plastic_at(ElementIndex e, Point start) const {
  return scene_.groups.of(e).plastic_at(scene_.parts(), e, motion_, start);
}

std::optional<PlasticTotals> StandardStepper::plastic_totals() const {
  PlasticTotals totals;
  for (const auto& group : scene_.groups) group->add_plastic(motion_, totals);
  if (totals.area == 0) return std::nullopt;
  if (scene_.settings.standard.motion != MotionRule::dynamic)
    totals.work = plastic_work_;
  else if (scene_.settings.ledger == Bookkeeping::on)
    totals.work = ledger_.flow.plastic;
  return totals;
}

ContactFrames StandardStepper::contacts() const {
  return contact_frames(scene_, motion_, state_, unloaded_, vertices_before_);
}

auto StandardStepper::contacts_later() const -> std::function<ContactFrames()> {
  return contact_frames_later(scene_, motion_, state_, unloaded_, vertices_before_);
}

std::variant<StepReport, StepFailure> StandardStepper::advance(const BetterPulls& better) {
  if (!start_failure_.empty()) return failure_of_start(scene_, start_failure_, turned_at_start_);
  const double load_share = scene_.load_share;
  const std::vector<FacePull> pulls = scene_.pulls;
  ControlledStep made;
  try {
    made = make_step(better);
  } catch (const StopRequested&) {
    scene_.load_share = load_share;
    scene_.pulls = pulls;
    throw;
  }
  if (!made.step.converged || !made.step.failure.empty()) {
    if (!made.step.moving.empty()) attempted_ = state_of(scene_, made.step.motion);
    return failure_of(scene_, motion_, state_, made.step);
  }
  State end = state_of(scene_, made.step.motion);
  made.step.turned = impossible(end);
  if (made.step.turned) made.step.failure = turned_inside_out(scene_, *made.step.turned, state_, end);
  if (made.step.failure.empty()) made.step.failure = too_deep(scene_, made.step.motion, end);
  if (!made.step.failure.empty()) return failure_of(scene_, motion_, state_, made.step);
  end.step = state_.step + 1;
  end.time = time_after(state_.time, scene_.settings.time_step);
  end.dt = scene_.settings.time_step;
  for (const auto& group : scene_.groups) plastic_work_ += group->plastic_work(motion_, made.step.motion);
  motion_ = made.step.motion;
  next_part_ = made.next;
  begins_scene_ = false;
  vertices_before_ = std::move(state_.vertices);
  state_ = std::move(end);
  if (scene_.settings.ledger == Bookkeeping::on) book(made.step);
  return report_of(scene_, motion_, state_, made);
}

ControlledStep StandardStepper::make_step() {
  const Settings& settings = scene_.settings;
  const double dt = settings.time_step;
  if (settings.standard.motion != MotionRule::dynamic)
    return whole(scene_, motion_.q,
                 equilibrium_of_lots(scene_, motion_, {state_.step, state_.time, state_.time + dt, begins_scene_}), dt);
  Motion start = motion_;
  for (const auto& group : scene_.groups) group->carry_over(scene_.parts(), start.v);
  ControlledStep made = settings.step_control == StepControl::constant
                            ? whole(scene_, motion_.q, standard_step(scene_, start, state_.time, dt), dt)
                            : controlled_step(scene_, start, state_.time, dt, next_part_);
  made.step.account.flow.damping += kinetic_energy(scene_, motion_.v) - kinetic_energy(scene_, start.v);
  return made;
}

ControlledStep StandardStepper::make_step(const BetterPulls& better) {
  ControlledStep made = make_step();
  while (better && made.step.converged && made.step.failure.empty()) {
    const std::optional<CoverDisplacement> end = displacement_of(scene_, made.step.motion);
    if (!end || !better(*end, scene_.pulls)) break;
    const int solves = made.step.solves;
    made = make_step();
    made.step.solves += solves;
  }
  return made;
}

void StandardStepper::book(const StandardStep& step) {
  const LedgerRow last = ledger_;
  ledger_ = ledger_row(scene_, motion_);
  ledger_.step = state_.step;
  ledger_.time = state_.time;
  ledger_.flow = last.flow;
  ledger_.impulse = last.impulse;
  ledger_.flow += step.account.flow;
  ledger_.impulse += step.account.impulse;
}

}  // namespace keyblock
