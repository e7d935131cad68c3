// Computes contact forces from the lengths of springs after the last solve.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/contact/contact_frames.hpp"

#include "legacy/contact/line.hpp"

namespace keyblock {
namespace {

Line line_at(const Table<VertexIndex, Point>& vertices, const Triple& t) {
  return {vertices[t.vertex], vertices[t.start], vertices[t.end]};
}

/// Returns the line with the spring of the last solve. An open contact had none, and a corner may change sides
/// afterwards.
const Triple& line_in_solve(const Contact& contact) {
  return contact.state_before == ContactState::on_second_line ? contact.second : contact.first;
}

ContactCondition condition_of(const Contact& contact) {
  if (contact.is_open()) return ContactCondition::open;
  return contact.state == ContactState::locked ? ContactCondition::stick : ContactCondition::slide;
}

// Shi's normal springs push a point that is inside, against the distance; shear springs act against the slip.
void put_forces(const Contact& contact, const ContactRules& rules, ContactFrame& frame) {
  if (contact.state_before == ContactState::open) return;
  frame.normal_force = -contact.penalty * contact.spring;
  const double shear = contact.state_before == ContactState::locked ? contact.penalty / rules.shear_ratio * contact.slip
                                                                    : contact.friction;
  // The line is opposite to the tangent, which is the normal rotated by +90 degrees.
  frame.shear_force = contact.kind == ContactKind::vertex_edge ? shear : 0;
}

}  // namespace

ContactFrames contact_frames(const Contacts& contacts, const Model& model, const State& state,
                             const StartPlaces& unloaded, const ContactRules& rules,
                             const Table<VertexIndex, Point>& before) {
  const Table<VertexIndex, Point>& acting = before.size() == state.vertices.size() ? before : state.vertices;
  ContactFrames frames;
  for (const Contact& contact : contacts) {
    const Triple& triple = contact.is_open() ? line_in_solve(contact) : contact.active();
    const Line now = line_at(state.vertices, triple);
    const Line then = line_at(acting, line_in_solve(contact));
    const Line first = line_at(unloaded.vertices, triple);
    ContactFrame frame;
    frame.element = model.identities.of_element(model.vertices[triple.vertex].element.value).number;
    frame.other = model.identities.of_element(model.vertices[triple.start].element.value).number;
    frame.joint_material = model.vertices[triple.start].joint_material;
    frame.edge = triple.start.value - model.elements[model.vertices[triple.start].element].first_vertex.value;
    frame.condition = condition_of(contact);
    frame.position = now.p1;
    const Point along = (1 / then.size()) * then.along();
    frame.normal = {-along.y, along.x};
    frame.gap = now.distance();
    if (contact.kind == ContactKind::vertex_edge) frame.slip = (first.projection() - now.projection()) * first.size();
    put_forces(contact, rules, frame);
    frames.push_back(frame);
  }
  return frames;
}

}  // namespace keyblock
