// Takes positions from the current state and forces from the memories of closed contacts.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/contact_frames.hpp"

#include <algorithm>

#include "step/scene/contact_laws.hpp"
#include "step/scene/touch_search.hpp"

namespace keyblock {
namespace {

Table<VertexIndex, Point> in_the_middle(const Table<VertexIndex, Point>& before,
                                        const Table<VertexIndex, Point>& after) {
  Table<VertexIndex, Point> middle;
  for (const VertexIndex v : indices(after)) middle.push_back(0.5 * (before[v] + after[v]));
  return middle;
}

// The slip compares unloaded positions: from the foot of the point on the edge to the point, along the edge.
double slip_of(const Touch& touch, const Table<VertexIndex, Point>& now, const Table<VertexIndex, Point>& unloaded) {
  if (touch.kind == TouchKind::arc) return 0;
  const Point edge = now[touch.end] - now[touch.start];
  const double share = dot(point_of(touch, now) - now[touch.start], edge) / dot(edge, edge);
  const Point edge_then = unloaded[touch.end] - unloaded[touch.start];
  const Point from_start = point_of(touch, unloaded) - unloaded[touch.start];
  return share * length(edge_then) - dot(from_start, edge_then) / length(edge_then);
}

ContactCondition condition_of(const StandardScene& scene, const Motion& motion, const ClosedContact& contact) {
  const ContactLaw law = contact_law(scene, motion.bonds, contact.touch);
  return law.is_bonded || sticks(law, contact.memory.normal, contact.memory.tangential) ? ContactCondition::stick
                                                                                        : ContactCondition::slide;
}

std::vector<ClosedContact> with_open_ones(const StandardScene& scene, const Motion& motion, const State& state) {
  std::vector<ClosedContact> contacts = motion.closed.all();
  const std::size_t closed = contacts.size();
  const Scales scales = scales_at(scene, motion, state.time);
  for (const Touch& touch : touches_of(scene, motion, scales, scene.settings.time_step))
    if (motion.closed.of(touch) == nullptr) contacts.push_back({touch, {}});
  std::sort(contacts.begin() + static_cast<std::ptrdiff_t>(closed), contacts.end(),
            [](const ClosedContact& a, const ClosedContact& b) { return a.touch < b.touch; });
  return contacts;
}

}  // namespace

ContactFrames contact_frames(const StandardScene& scene, const Motion& motion, const State& state,
                             const StartPlaces& unloaded, const Table<VertexIndex, Point>& before) {
  const Model& model = scene.model;
  const bool is_in_time = scene.settings.standard.motion == MotionRule::dynamic;
  const bool has_moved = is_in_time && before.size() == state.vertices.size();
  const Table<VertexIndex, Point> middle =
      has_moved ? in_the_middle(before, state.vertices) : Table<VertexIndex, Point>();
  const std::size_t closed = motion.closed.size();
  ContactFrames frames;
  for (const ClosedContact& contact : with_open_ones(scene, motion, state)) {
    const Touch& touch = contact.touch;
    ContactFrame frame;
    frame.element = model.identities.of_element(model.vertices[touch.vertex].element.value).number;
    frame.other = model.identities.of_element(model.vertices[touch.start].element.value).number;
    frame.joint_material = touch.joint_material;
    frame.edge = edge_under(touch, model, state.vertices).value -
                 model.elements[model.vertices[touch.start].element].first_vertex.value;
    if (frames.size() < closed) frame.condition = condition_of(scene, motion, contact);
    frame.position = point_of(touch, state.vertices);
    frame.normal = normal_of(touch, has_moved ? middle : state.vertices);
    frame.gap = gap_of(touch, state.vertices);
    frame.slip = slip_of(touch, state.vertices, unloaded.vertices);
    frame.normal_force = contact.memory.normal;
    frame.shear_force = contact.memory.tangential;
    frames.push_back(frame);
  }
  return frames;
}

LaterContacts contact_frames_later(const StandardScene& scene, const Motion& motion, const State& state,
                                   const StartPlaces& unloaded, const Table<VertexIndex, Point>& before) {
  const bool changes_scene = scene.settings.standard.motion != MotionRule::dynamic || !scene.pulls.empty();
  if (changes_scene) return [made = contact_frames(scene, motion, state, unloaded, before)] { return made; };
  return [&scene, &unloaded, motion, state, before] { return contact_frames(scene, motion, state, unloaded, before); };
}

}  // namespace keyblock
