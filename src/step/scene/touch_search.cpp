// Reach from speeds, slack from springs; pairs of which neither can move are left out.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/touch_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "base/loop.hpp"
#include "contact/rows/gap.hpp"
#include "step/newton/tolerances.hpp"

namespace keyblock {
namespace {

// Blocks may move twice as far as they do at the present speed before a pair outside the list could touch.
constexpr double kReachOverTravel = 2;
// Touching blocks are within reach whatever the speed: round-off of file coordinates, as a share of block size.
constexpr double kReachAtRest = 1e-6;
// Overlap that a step may leave between corners it did not reckon with, as a share of block size: the next step sees
// it.
constexpr double kNewOverlap = 1e-9;

// Overlap at the start of a step that it may push out, as a share of block size: round-off of coordinates far from the
// origin, and what a solution left. At half a millisecond a block of metres leaves it with a millimetre a second.
constexpr double kPushedOut = 1e-7;

// Least rounding of corners, as a share of block size: what springs and strains make of corners that were drawn as one.
constexpr double kLeastRounding = 1e-6;
// Overlap that closes corners again which were closed in the last step and left open in this one, as a share of block
// size: no more than round-off, or they would gain speed until it is more.
constexpr double kPressed = 1e-12;
// Change of the force on such a corner, as a share of it, after which it is tried again whether they pass.
constexpr double kAsPressed = 0.1;

// Cosine of the angle between two faces that carry a block as one: two and a half degrees.
constexpr double kSameLine = 0.999;

double top_speed(const StandardScene& scene, const UnknownsTable& v) {
  double top = 0;
  for (const auto& group : scene.groups) top = std::max(top, group->fastest_point(v));
  return top;
}

// Neither what springs give, along the face too, nor what overlap closed contacts were left with is one between
// corners; twice the greatest of an element is on the safe side, for what it meets next too. `vertices`: of the motion.
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

void name_joints(Touches& touches, const Model& model, const Table<VertexIndex, Point>& vertices) {
  for_each_entry(touches.size(),
                 [&](std::size_t i) { touches[i].joint_material = joint_under(touches[i], model, vertices); });
}

FoundTouches found_within(const StandardScene& scene, const Table<VertexIndex, Point>& vertices,
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
  name_joints(found.touches, scene.model, vertices);
  for (CornerTie& tie : found.ties) {
    name_joints(tie.candidates, scene.model, vertices);
    name_joints(tie.sharp, scene.model, vertices);
  }
  return found;
}

// Two convex pieces of a notched block may meet the same corner, one along an edge and one at the corner alone: that is
// one contact, with one memory. The rest stay in their order.
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

}  // namespace

// Vertices on a straight edge part it, and each part has a joint of its own.
VertexIndex edge_under(const Touch& touch, const Model& model, const Table<VertexIndex, Point>& vertices) {
  VertexIndex part = model.vertices[touch.start].next;
  const Point along = vertices[touch.end] - vertices[touch.start];
  const double station = dot(point_of(touch, vertices) - vertices[touch.start], along);
  while (part != touch.end && dot(vertices[part] - vertices[touch.start], along) < station)
    part = model.vertices[part].next;
  return part;
}

namespace {

// Tells whether a closed touch guides one of the corners of a tie along the edge of a candidate, or along a face in
// line with it. Where two faces end together, the corner of either may name their touch: both names count.
bool is_guided_along(const Touch& candidate, const Touches& touches, const Motion& motion,
                     const Table<VertexIndex, Point>& vertices, double rounding) {
  const Point line = normal_of(candidate, vertices);
  const VertexIndex corner = candidate.vertex;
  const auto lies_on_edge = [&](const Touch& touch) {
    const auto& [lower, upper, place] = touch.facing;
    const bool faces = lower && (lower == candidate.start || upper == candidate.start);
    return faces || (touch.start == candidate.start && touch.end == candidate.end);
  };
  const auto lies_in_line = [&](const Touch& touch) {
    const double aligned = dot(normal_of(touch, vertices), line);
    if (touch.vertex == corner) return aligned > kSameLine;
    const bool ends_there = touch.start == corner || touch.end == corner;
    return ends_there && distance(vertices[touch.vertex], vertices[corner]) <= rounding && -aligned > kSameLine;
  };
  return std::ranges::any_of(touches, [&](const Touch& touch) {
    return motion.closed.of(touch) && (lies_on_edge(touch) || lies_in_line(touch));
  });
}

// Whether two corners may slide past each other: one is guided along another edge than that of the touch, and they
// overlap by no more than the rounding. At a crossing of joints opposite blocks meet so: what one has sunk by more than
// the other would be a step in the joint, and a slope would hang on it.
bool may_pass(const CornerTie& tie, const Touch& taken, const Touches& touches, const Motion& motion,
              const Table<VertexIndex, Point>& vertices, double rounding) {
  if (distance(vertices[taken.vertex], vertices[taken.other]) > rounding) return false;
  const Point normal = normal_of(taken, vertices);
  return std::ranges::any_of(tie.candidates, [&](const Touch& other) {
    return other.kind == TouchKind::corner && gap_of(other, vertices) >= -rounding &&
           std::abs(dot(normal, normal_of(other, vertices))) <= kSameLine &&
           is_guided_along(other, touches, motion, vertices, rounding);
  });
}

const Touch* closed_before(const CornerTie& tie, const Motion& motion) {
  const auto is_closed = [&](const Touch& touch) { return motion.closed.of(touch) != nullptr; };
  const auto closed = std::ranges::find_if(tie.candidates, is_closed);
  return closed == tie.candidates.end() ? nullptr : &*closed;
}

// Corners that pass each other along no line within their rounding, as fast as they go, strike each other as if they
// were sharp: an impact has to be known before it overlaps.
void sharpen_struck_corners(const StandardScene& scene, const Motion& motion, double dt,
                            const Table<VertexIndex, Point>& vertices, FoundTouches& found) {
  const auto may_strike = [&](const CornerTie& tie) { return !tie.sharp.empty() && !closed_before(tie, motion); };
  const auto is_edge = [](const Touch& touch) { return touch.kind == TouchKind::corner; };
  Touches edges;
  for (const CornerTie& tie : found.ties)
    if (may_strike(tie)) std::ranges::copy_if(tie.candidates, std::back_inserter(edges), is_edge);
  if (edges.empty()) return;
  const Eigen::VectorXd speeds = rates(contact_rows(scene.model, scene.reference, motion.q, edges), motion.v);
  Touches struck;
  Eigen::Index row = 0;
  std::erase_if(found.ties, [&](const CornerTie& tie) {
    if (!may_strike(tie)) return false;
    bool strikes = true;
    for (const Touch& touch : tie.candidates) {
      if (!is_edge(touch)) continue;
      if (gap_of(touch, vertices) + speeds[row] * dt >= -tie.rounding) strikes = false;
      row += 2;
    }
    if (strikes) struck.insert(struck.end(), tie.sharp.begin(), tie.sharp.end());
    return strikes;
  });
  drop_known(struck, found.touches);
  found.touches.insert(found.touches.end(), struck.begin(), struck.end());
}

double most_overlap(const StandardScene& scene, const Touch& touch, const Scales& scales) {
  const auto of = [&](VertexIndex v) { return scene.rounding[scene.model.vertices[v].element]; };
  return std::max(kLeastRounding * scales.size, std::min(of(touch.vertex), of(touch.start)));
}

// A corner that is pressed as it was when the motion without it closed it again is not tried once more.
bool was_tried(const ContactMemory& memory) {
  return memory.tried_at != 0 && std::abs(memory.normal - memory.tried_at) <= kAsPressed * std::abs(memory.tried_at);
}

}  // namespace

FoundTouches touches_of(const StandardScene& scene, const Motion& motion, const Scales& scales, double dt,
                        GuidedCorners guided) {
  const double travel = (top_speed(scene, motion.v) + scales.acceleration * dt) * dt;
  const double reach = kReachOverTravel * travel + kReachAtRest * scales.size;
  const auto vertices = vertices_at(scene.model, scene.reference, motion.q);
  FoundTouches found = found_within(scene, vertices, search_of(scene, motion, vertices, reach));
  if (guided == GuidedCorners::by_motion) sharpen_struck_corners(scene, motion, dt, vertices, found);
  Touches closed;
  for (const CornerTie& tie : found.ties) {
    const Touch* touch = closed_before(tie, motion);
    if (!touch) continue;
    const bool is_tried = guided == GuidedCorners::by_motion && was_tried(*motion.closed.of(*touch));
    const bool is_held =
        is_tried || !may_pass(tie, *touch, found.touches, motion, vertices, most_overlap(scene, *touch, scales));
    (is_held ? closed : found.released).push_back(*touch);
  }
  drop_known(closed, found.touches);
  found.touches.insert(found.touches.end(), closed.begin(), closed.end());
  return found;
}

Touches newly_overlapping(const StandardScene& scene, const Motion& start, const Table<VertexIndex, Point>& vertices,
                          const FoundTouches& known, const Scales& scales, GuidedCorners guided) {
  Touches sorted = known.touches;
  std::set<Touch> added;
  bool is_sorted = false;  // few steps have a touch to look up
  std::vector<Facing> facings;
  // New by name; a bonded touch also at the same end of the same two faces, where the other edge leads now: its bond is
  // counted.
  const auto is_new = [&](const Touch& touch) {
    if (!std::exchange(is_sorted, true)) {
      std::ranges::sort(sorted);
      for (const Touch& one : sorted)
        if (one.facing.lower && lies_over_edge(one, vertices)) facings.push_back(one.facing);
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
  const FoundTouches found = found_within(scene, vertices, search);
  // A point that lay behind the line of an edge before the motion did not come in through that edge where it overlaps
  // another one, through which it came: that one takes it.
  const auto bodies = [&](const Touch& touch) {
    return std::minmax({scene.model.vertices[touch.vertex].element, scene.model.vertices[touch.start].element});
  };
  const auto came_through_another = [&](const Touch& touch) {
    return gap_of(touch, before) < -overlap - slack_of(touch) &&
           std::ranges::any_of(known.touches, [&](const Touch& other) {
             return bodies(other) == bodies(touch) && gap_of(other, vertices) < -overlap &&
                    gap_of(other, before) >= -overlap - slack_of(other) && lies_over_edge(other, vertices);
           });
  };
  for (const Touch& touch : found.touches)
    if (gap_of(touch, vertices) < -overlap - slack_of(touch) && is_new(touch) && !came_through_another(touch)) {
      added.insert(touch);
      fresh.push_back(touch);
    }
  // A known touch whose corner has run past the end of its edge takes nothing.
  const auto takes_none = [&](const Touch& touch) { return is_new(touch) || !lies_over_edge(touch, vertices); };
  for (const std::vector<CornerTie>* ties : {&known.ties, &found.ties}) {
    for (const CornerTie& tie : *ties) {
      const bool was_closed = closed_before(tie, start) != nullptr;
      const Touch* touch = touch_of(tie, before, vertices, was_closed ? kPressed * scales.size : overlap);
      if (!touch || !is_new(*touch) || !std::ranges::all_of(tie.candidates, takes_none)) continue;
      const bool passes =
          guided == GuidedCorners::pass || std::ranges::binary_search(start.passing, corners_of(*touch));
      if (passes && may_pass(tie, *touch, known.touches, start, vertices, most_overlap(scene, *touch, scales)))
        continue;
      added.insert(*touch);
      fresh.push_back(*touch);
    }
  }
  return fresh;
}

namespace {

// Compression of the spring that the corner of a touch had against another face on nearly one line with it, and has no
// more: a block that slides on over the joint of two bases goes on as deep as it was, and nothing is gained by it.
double handed_on(const Motion& start, const Touch& touch, const Touches& present,
                 const Table<VertexIndex, Point>& vertices) {
  if (touch.kind != TouchKind::corner) return 0;
  const Point normal = normal_of(touch, vertices);
  for (const auto& [other, memory] : start.closed.at(touch.vertex)) {
    if (other.kind != TouchKind::corner || std::ranges::count(present, other) > 0) continue;
    if (dot(normal, normal_of(other, vertices)) > kSameLine) return memory.compression;
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

Touches resting_touches(const StandardScene& scene, const Motion& motion, const Scales& scales) {
  const double dt = scene.settings.time_step;
  const Touches all = touches_of(scene, motion, scales, dt, GuidedCorners::pass).touches;
  const double slow = slow_speed(scene, scales, motion.v, dt);
  const Eigen::VectorXd speeds = rates(contact_rows(scene.model, scene.reference, motion.q, all), motion.v);
  const auto vertices = vertices_at(scene.model, scene.reference, motion.q);
  Touches touches;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool touching = std::abs(gap_of(all[i], vertices)) < tolerances::of_gaps::kTouching * scales.size;
    if (touching && std::abs(speeds[static_cast<Eigen::Index>(2 * i)]) <= slow) touches.push_back(all[i]);
  }
  return touches;
}

}  // namespace keyblock
