// Implements the stepper: a stop within a step restores the state before it, and saving lists the members.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/shi_stepper.hpp"

#include <utility>

#include "base/context.hpp"
#include "legacy/contact/contact_frames.hpp"
#include "legacy/contact/springs.hpp"
#include "legacy/step/shi_ledger.hpp"
#include "model/describe_state.hpp"

namespace keyblock {
namespace {

void describe(Archive& a, const char* name, Triple& triple, VertexIndex vertices) {
  a.group(name, [&] {
    a.index("vertex", triple.vertex, vertices);
    a.index("start", triple.start, vertices);
    a.index("end", triple.end, vertices);
  });
}

void describe(Archive& a, Contact& contact, VertexIndex vertices) {
  a.choice("kind", contact.kind, ContactKind::vertex_vertex);
  describe(a, "first", contact.first, vertices);
  describe(a, "second", contact.second, vertices);
  a.value("parallel_pair", contact.parallel_pair);
  a.index("neighbour", contact.neighbour, vertices);
  a.choice("state", contact.state, ContactState::on_second_line);
  a.choice("state_before", contact.state_before, ContactState::on_second_line);
  a.value("distance", contact.distance);
  a.value("slip", contact.slip);
  a.value("ratio", contact.ratio);
  a.value("length", contact.length);
  a.value("penalty", contact.penalty);
  a.value("bonded", contact.bonded);
}

// The solver saves only its decision against iterations: its factorisation equals that of any new solver.
void describe(Archive& a, Stepping& stepping) {
  a.group("state", [&] { describe(a, stepping.state); });
  const VertexIndex vertices = stepping.state.vertices.end_index();
  a.list("contacts", stepping.contacts, [&](Contact& contact) { describe(a, contact, vertices); });
  a.value("dt", stepping.history.dt);
  a.value("displacement_ratio", stepping.history.displacement_ratio);
  a.value("penetration", stepping.history.penetration);
  a.value("last_penalty", stepping.history.penalty);
  a.value("penalty", stepping.penalty);
  a.value("has_solved", stepping.has_solved);
  a.value("gave_up_iterations", stepping.solver.gave_up_iterations);
  a.value("work", stepping.work);
}

}  // namespace

ShiStepper::ShiStepper(Scene scene)
    : scene_(shi_scene(std::move(scene))), stepping_(start(scene_)), unloaded_(places_of(stepping_.state)) {}

ShiStepper::ShiStepper(Scene scene, Archive& saved) : ShiStepper(std::move(scene)) {
  describe(saved, stepping_);
  // Forces of the last solve are not saved; the later judgement gives an approximation.
  Contacts& contacts = stepping_.contacts;
  for (Contact& contact : contacts) contact.spring = contact.distance;
  contacts = with_friction(std::move(contacts), std::vector<bool>(contacts.size(), true), scene_.model);
}

std::variant<StepReport, StepFailure> ShiStepper::advance() {
  const bool had_solved = stepping_.has_solved;
  const bool gave_up = stepping_.solver.gave_up_iterations;
  const bool does_work = scene_.settings.ledger == Bookkeeping::on && keyblock::does_work(model(), settings());
  const State start = does_work ? state() : State();
  Table<VertexIndex, Point> before = state().vertices;
  try {
    std::variant<StepReport, StepFailure> made = keyblock::advance(scene_, stepping_);
    if (std::holds_alternative<StepFailure>(made)) return made;
    vertices_before_ = std::move(before);
    if (does_work) stepping_.work += work_of_step(model(), settings(), start, state());
    return made;
  } catch (const StopRequested&) {
    stepping_.has_solved = had_solved;
    stepping_.solver.gave_up_iterations = gave_up;
    throw;
  }
}

ContactFrames ShiStepper::contacts() const {
  return contact_frames(stepping_.contacts, scene_.model, state(), unloaded_, scene_.rules, vertices_before_);
}

LedgerRow ShiStepper::ledger() const {
  LedgerRow row = stored_row(scene_.model, scene_.settings, state(), unloaded_);
  row.flow.external = stepping_.work;
  return row;
}

LedgerScope ShiStepper::ledger_scope() const {
  return stored_scope(unloaded_);
}

void ShiStepper::save(Archive& archive) {
  describe(archive, stepping_);
}

}  // namespace keyblock
