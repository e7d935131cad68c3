// Finds contact candidates. Speeds give the reach, springs the slack; pairs of two immovable blocks are left out.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/touch_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "base/loop.hpp"
#include "contact/rows/gap.hpp"
#include "step/newton/tolerances.hpp"

namespace keyblock {
namespace {

// Blocks may move at twice their present speed before a pair outside the list could touch.
constexpr double kReachOverTravel = 2;
// Least reach at any speed, relative to block size: round-off of file coordinates.
constexpr double kReachAtRest = 1e-6;
// Overlap, relative to block size, that a step may leave at corners that it did not consider. The next step sees it.
constexpr double kNewOverlap = 1e-9;

// Initial overlap, relative to block size, that a step may push out: round-off of coordinates far from the origin, and
// errors of earlier solutions. In a step of half a millisecond a block of metres leaves it at a millimetre per second.
constexpr double kPushedOut = 1e-7;

// Difference of the gaps of an arc and of its edge that counts as round-off, relative to the length of the arc.
constexpr double kNoSinking = 1e-9;

double top_speed(const StandardScene& scene, const UnknownsTable& v) {
  double top = 0;
  for (const auto& group : scene.groups) top = std::max(top, group->fastest_point(v));
  return top;
}

// Neither compression of springs, nor their slip along the face, nor old overlaps of closed contacts count as overlap
// of corners. Twice the greatest value of an element is safe also for its next contact. `vertices`: of the motion.
TouchSearch search_of(const StandardScene& scene, const Motion& motion, const Table<VertexIndex, Point>& vertices,
                      double reach) {
  TouchSearch search{reach, {}, scene.has_springs() && scene.settings.standard.spring_points == SpringPoints::lobatto};
  search.rounding = &scene.rounding;
  search.slack.assign(scene.model.elements.size(), 0);
  for (const auto& [touch, memory] : motion.closed.all()) {
    if (memory.normal_compliance == 0) continue;
    const double overlap = std::max({memory.normal * memory.normal_compliance, -gap_of(touch, vertices),
                                     std::abs(memory.tangential) * memory.tangential_compliance});
    for (const VertexIndex v : {touch.vertex, touch.start}) {
      double& slack = search.slack[scene.model.vertices[v].element];
      slack = std::max(slack, 2 * overlap);
    }
  }
  return search;
}

int joint_under(const Touch& touch, const Model& model, const Table<VertexIndex, Point>& vertices) {
  return model.vertices[edge_under(touch, model, vertices)].joint_material;
}

// Two convex pieces of a notched block may meet the same corner, one along an edge and one at the corner alone. That is
// one contact, with one memory. The rest stay in order.
void drop_known(Touches& touches, const Touches& known) {
  if (touches.empty()) return;
  std::set<Touch> names(touches.begin(), touches.end());
  std::set<Facing> facings;
  for (const Touch& touch : touches)
    if (touch.facing.lower) facings.insert(touch.facing);
  std::set<Touch> known_names;
  std::set<Facing> known_facings;
  for (const Touch& one : known) {
    if (names.contains(one)) known_names.insert(one);
    if (one.facing.lower && facings.contains(one.facing)) known_facings.insert(one.facing);
  }
  std::erase_if(touches, [&](const Touch& touch) {
    return known_names.contains(touch) || known_facings.contains(touch.facing) || !known_names.insert(touch).second;
  });
}

// A corner supported by an edge stays there if the arc at the end of the edge would let it sink. A block that rocks on
// the end of its base has no arc under it.
bool stays_sharp(const CornerMeeting& meeting, const Motion& motion, const Table<VertexIndex, Point>& vertices) {
  const Touch& arc = meeting.arc;
  return std::ranges::any_of(meeting.sharp, [&](const Touch& touch) {
    const auto is_it = [&](const ClosedContact& contact) {
      return contact.touch == touch || (touch.facing.lower && contact.touch.facing == touch.facing);
    };
    if (std::ranges::none_of(motion.closed.at(touch.vertex), is_it)) return false;
    return is_guided(touch, arc) && gap_of(arc, vertices) > gap_of(touch, vertices) + kNoSinking * arc.tangent;
  });
}

// Returns the distance of a corner's foot from the nearer end of the edge, positive inside.
double within_ends(const Touch& touch, const Table<VertexIndex, Point>& vertices) {
  const Point edge = vertices[touch.end] - vertices[touch.start];
  const double station = dot(vertices[touch.vertex] - vertices[touch.start], edge) / length(edge);
  return std::min(station, length(edge) - station);
}

/// Marks faces that bear on another one, by their start vertices.
Table<VertexIndex, char> bearing_faces(const StandardScene& scene, const ClosedContacts& closed) {
  Table<VertexIndex, char> faces;
  faces.assign(scene.model.vertices.size(), 0);
  for (const ClosedContact& contact : closed.all())
    if (const Facing& facing = contact.touch.facing; facing.lower) faces[facing.lower] = faces[facing.upper] = 1;
  return faces;
}

// Returns the arc, or the contact along an edge that replaces it. A bearing face may lie slightly behind the line of
// the next one, because rock sinks and springs give. It then slides on as if both were level, without a step. The next
// face carries once the corner has passed the rounding.
Touches taken_of(const CornerMeeting& meeting, const Table<VertexIndex, char>& bearing, const Motion& motion,
                 const Table<VertexIndex, Point>& vertices) {
  const Touch& arc = meeting.arc;
  for (const auto& [touch, face] : meeting.in_line)
    if ((bearing[face] || bearing[touch.start]) && std::abs(gap_of(touch, vertices)) < arc.tangent)
      return within_ends(touch, vertices) > meeting.rounding ? Touches{touch} : Touches{};
  return stays_sharp(meeting, motion, vertices) ? meeting.sharp : Touches{arc};
}

Touches found_within(const StandardScene& scene, const Motion& motion, const Table<VertexIndex, Point>& vertices,
                     const TouchSearch& search) {
  State state;
  state.vertices = vertices;
  std::vector<ElementPair> pairs = close_pairs(scene.model, state, scene.with_faces, search.reach);
  std::erase_if(pairs, [&](const ElementPair& pair) {
    const Element& lower = scene.model.elements[pair.lower];
    const Element& upper = scene.model.elements[pair.upper];
    return share_a_cover(lower, upper) || (!lower.can_move() && !upper.can_move());
  });
  FoundTouches found = find_touches(pairs, scene.pieces, vertices, search);
  Touches met;
  const Table<VertexIndex, char> bearing = bearing_faces(scene, motion.closed);
  for (const CornerMeeting& meeting : found.meetings) {
    const Touches taken = taken_of(meeting, bearing, motion, vertices);
    met.insert(met.end(), taken.begin(), taken.end());
  }
  drop_known(met, found.touches);
  found.touches.insert(found.touches.end(), met.begin(), met.end());
  name_joints(found.touches, scene.model, vertices);
  return std::move(found.touches);
}

}  // namespace

void name_joints(Touches& touches, const Model& model, const Table<VertexIndex, Point>& vertices) {
  for_each_entry(touches.size(),
                 [&](std::size_t i) { touches[i].joint_material = joint_under(touches[i], model, vertices); });
}

// Vertices on a straight edge divide it, and each part has a joint of its own.
VertexIndex edge_under(const Touch& touch, const Model& model, const Table<VertexIndex, Point>& vertices) {
  const Touch on_edge = touch.kind != TouchKind::arc
                            ? touch
                            : guided(touch, share_of_second(touch, vertices) < 0.5 ? touch.first : touch.second);
  VertexIndex part = model.vertices[on_edge.start].next;
  const Point along = vertices[on_edge.end] - vertices[on_edge.start];
  const double station = dot(point_of(on_edge, vertices) - vertices[on_edge.start], along);
  while (part != on_edge.end && dot(vertices[part] - vertices[on_edge.start], along) < station)
    part = model.vertices[part].next;
  return part;
}

namespace {

double widest_gap(const Bonds& bonds) {
  double widest = 0;
  for (const auto& [facing, bond] : bonds) widest = std::max(widest, bond.gap);
  return widest;
}

// Bonded faces stay within reach however far apart they were drawn.
Touches touches_within(const StandardScene& scene, const Motion& motion, const Scales& scales, double dt,
                       double least) {
  const double travel = (top_speed(scene, motion.v) + scales.acceleration * dt) * dt;
  const double drawn_apart = std::max(least, kReachAtRest * scales.size + widest_gap(motion.bonds));
  const auto vertices = vertices_at(scene.model, scene.reference, motion.q);
  return found_within(scene, motion, vertices,
                      search_of(scene, motion, vertices, kReachOverTravel * travel + drawn_apart));
}

}  // namespace

Touches touches_of(const StandardScene& scene, const Motion& motion, const Scales& scales, double dt) {
  return touches_within(scene, motion, scales, dt, 0);
}

namespace {

// Returns true if a known contact has a corner of the arc over an edge of the other. Over edges of `vertex`, it must
// also overlap.
bool is_taken(const Touch& arc, const Touches& known, const Table<VertexIndex, Point>& vertices, double overlap) {
  if (arc.kind != TouchKind::arc) return false;
  const auto takes = [&](const Touch& touch, VertexIndex vertex, VertexIndex met) {
    return touch.kind == TouchKind::corner && touch.vertex == vertex && (touch.start == met || touch.end == met) &&
           lies_over_edge(touch, vertices);
  };
  return std::ranges::any_of(known, [&](const Touch& touch) {
    return takes(touch, arc.vertex, arc.start) ||
           (takes(touch, arc.start, arc.vertex) && gap_of(touch, vertices) < -overlap);
  });
}

}  // namespace

Touches newly_overlapping(const StandardScene& scene, const Motion& start, const Table<VertexIndex, Point>& vertices,
                          const Touches& known, const Scales& scales) {
  Touches sorted = known;
  std::set<Touch> added;
  bool is_sorted = false;  // few steps have a contact to look up
  std::vector<Facing> facings;
  // A contact is new if its name is new and it does not lie along an edge that ends in a known arc. A bonded contact is
  // not new if the other edge now leads at the same end of the same two faces: its bond already counts.
  const auto is_new = [&](const Touch& touch) {
    if (!std::exchange(is_sorted, true)) {
      for (const Touch& one : known) {
        if (one.kind != TouchKind::arc) continue;
        sorted.insert(sorted.end(), {guided(one, one.first), guided(one, one.second)});
      }
      std::ranges::sort(sorted);
      for (const Touch& one : sorted)
        if (one.facing.lower) facings.push_back(one.facing);
      std::ranges::sort(facings);
    }
    if (start.bonds.contains(touch.facing) && std::ranges::binary_search(facings, touch.facing)) return false;
    return !std::ranges::binary_search(sorted, touch) && !added.contains(touch);
  };
  const double overlap = kNewOverlap * scales.size;
  const auto before = vertices_at(scene.model, scene.reference, start.q);
  const TouchSearch search = search_of(scene, start, before, 0);
  const auto slack_of = [&](const Touch& touch) {
    return search.slack_of(scene.model.vertices[touch.vertex].element, scene.model.vertices[touch.start].element);
  };
  Touches fresh;
  const Touches found = found_within(scene, start, vertices, search);
  // The gap may have been negative at an edge before the motion, while the point entered through another edge that it
  // overlaps now. The contact then belongs to the latter.
  const auto bodies = [&](const Touch& touch) {
    return std::minmax({scene.model.vertices[touch.vertex].element, scene.model.vertices[touch.start].element});
  };
  const auto came_through_another = [&](const Touch& touch) {
    return gap_of(touch, before) < -overlap - slack_of(touch) && std::ranges::any_of(known, [&](const Touch& other) {
             return bodies(other) == bodies(touch) && gap_of(other, vertices) < -overlap &&
                    gap_of(other, before) >= -overlap - slack_of(other) && lies_over_edge(other, vertices);
           });
  };
  for (const Touch& touch : found)
    if (gap_of(touch, vertices) < -overlap - slack_of(touch) && !is_taken(touch, known, vertices, overlap) &&
        is_new(touch) && !came_through_another(touch)) {
      added.insert(touch);
      fresh.push_back(touch);
    }
  return fresh;
}

namespace {

// Returns the former spring compression of the corner at another face, now left, on nearly the same line. A block that
// slides over the joint of two bases keeps its depth, and gains no energy.
double handed_on(const Motion& start, const Touch& touch, const Touches& present,
                 const Table<VertexIndex, Point>& vertices) {
  if (touch.kind != TouchKind::corner) return 0;
  const Point normal = normal_of(touch, vertices);
  for (const auto& [other, memory] : start.closed.at(touch.vertex)) {
    if (other.kind != TouchKind::corner || std::ranges::count(present, other) > 0) continue;
    if (dot(normal, normal_of(other, vertices)) > kInLine) return memory.compression;
  }
  return 0;
}

}  // namespace

void leave_overlaps(const StandardScene& scene, const Motion& start, const Scales& scales, Touches& touches) {
  if (scene.settings.standard.impact == ImpactLaw::springs) return;
  const auto vertices = vertices_at(scene.model, scene.reference, start.q);
  for_each_entry(touches.size(), [&](std::size_t i) {
    Touch& touch = touches[i];
    const ContactMemory* memory = start.closed.of(touch);
    const double overlap = -kPushedOut * scales.size;
    double gap = gap_of(touch, vertices);
    if (memory)
      gap += memory->compression;
    else if (gap < overlap && scene.has_springs())
      gap += handed_on(start, touch, touches, vertices);
    touch.rest_gap = gap < overlap ? gap : 0;
  });
}

Touches meeting_touches(const StandardScene& scene, const Motion& motion, const Scales& scales, double distance) {
  const double dt = scene.settings.time_step;
  const Touches all = touches_within(scene, motion, scales, dt, distance);
  const double slow = slow_speed(scene, scales, motion.v, dt);
  const Eigen::VectorXd speeds = rates(contact_rows(scene.model, scene.reference, motion.q, all), motion.v);
  const auto vertices = vertices_at(scene.model, scene.reference, motion.q);
  Touches touches;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool meets = std::abs(gap_of(all[i], vertices)) < distance || motion.bonds.contains(all[i].facing);
    if (meets && std::abs(speeds[static_cast<Eigen::Index>(2 * i)]) <= slow) touches.push_back(all[i]);
  }
  return touches;
}

Touches resting_touches(const StandardScene& scene, const Motion& motion, const Scales& scales) {
  return meeting_touches(scene, motion, scales, tolerances::of_gaps::kTouching * scales.size);
}

}  // namespace keyblock
