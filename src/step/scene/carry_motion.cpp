// Element by element, then contact by contact.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/carry_motion.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "contact/rows/constraints.hpp"
#include "geometry/segment.hpp"
#include "step/scene/contact_laws.hpp"
#include "step/scene/touch_search.hpp"

namespace keyblock {
namespace {

// Of the scene's scale: a point of a mesh on the edge of its block, within round-off of cutting.
constexpr double kOnEdge = 1e-9;

/// Where a material point of the later scene lies: it moves with what it was part of before.
class Before {
 public:
  Before(const StandardScene& scene, const Motion& motion, const SceneMap& map)
      : scene_(scene), motion_(motion), map_(map) {}

  Point place(ElementIndex e, Point start) const {
    return point_at(scene_.model, scene_.reference, motion_.q, map_.elements[e], start);
  }

 private:
  const StandardScene& scene_;
  const Motion& motion_;
  const SceneMap& map_;
};

/// Vertices of the scene before to those of the scene after, and what is known by them.
class Names {
 public:
  Names(const SceneMap& map, const StandardScene& before, const StandardScene& after) : after_(after.model) {
    now_.resize(before.model.vertices.size());
    for (VertexIndex v : indices(map.vertices))
      if (map.vertices[v] && !now_[map.vertices[v]]) now_[map.vertices[v]] = v;
  }

  std::optional<Touch> of(Touch touch) const {
    const bool same = rename(touch.vertex) && rename(touch.start) && rename(touch.end) && rename(touch.other) &&
                      rename(touch.first) && rename(touch.second) && rename(touch.facing);
    if (!same) return std::nullopt;
    if (touch.kind == TouchKind::arc)
      return is_edge(touch.first) && is_edge(touch.second) ? std::optional(touch) : std::nullopt;
    if (!is_edge({touch.start, touch.end})) return std::nullopt;
    if (touch.kind == TouchKind::middle && !is_edge({touch.vertex, touch.other}) &&
        !is_edge({touch.other, touch.vertex}))
      return std::nullopt;
    return touch;
  }

  /// False where one of its edges is gone.
  bool rename(Facing& facing) const {
    if (!facing.lower && !facing.upper) return true;
    return rename(facing.lower) && rename(facing.upper);  // blocks stay in order, and so do their edges
  }

 private:
  bool rename(VertexIndex& v) const {
    if (!v) return true;
    v = now_[v];
    return static_cast<bool>(v);
  }

  bool rename(EdgeName& edge) const { return rename(edge.start) && rename(edge.end); }

  bool is_edge(EdgeName edge) const { return after_.vertices[edge.start].next == edge.end; }

  const Model& after_;
  Table<VertexIndex, VertexIndex> now_;
};

ClosedContacts carried_contacts(const ClosedContacts& closed, const Names& names) {
  std::vector<ClosedContact> kept;
  for (const ClosedContact& contact : closed.all())
    if (const std::optional<Touch> touch = names.of(contact.touch)) kept.push_back({*touch, contact.memory});
  return ClosedContacts(std::move(kept));
}

/// Whether one of two edges that were there before is of another joint material now.
bool is_other_joint(const Facing& facing, const SceneMap& map, const StandardScene& before,
                    const StandardScene& after) {
  const auto is_other = [&](VertexIndex start) {
    const VertexIndex end = after.model.vertices[start].next;
    if (!map.vertices[start] || !map.vertices[end]) return false;
    return after.model.vertices[end].joint_material != before.model.vertices[map.vertices[end]].joint_material;
  };
  return is_other(facing.lower) || is_other(facing.upper);
}

/// Of edges of the later scene those of the earlier that they are, or lie on: a mesh parts the edges of its block.
class Edges {
 public:
  Edges(const SceneMap& map, const StandardScene& before, const StandardScene& after)
      : map_(map), before_(before.model), after_(after.model) {}

  bool is_new(VertexIndex start) const {
    const VertexIndex end = after_.vertices[start].next;
    return !map_.vertices[start] || !map_.vertices[end] ||
           before_.vertices[map_.vertices[start]].next != map_.vertices[end];
  }

  /// None where the edge lies on no edge of the element that its own was cut from.
  std::optional<VertexIndex> before(VertexIndex start) const {
    if (!is_new(start)) return map_.vertices[start];
    const Segment edge = segment(after_, start);
    for (VertexIndex v : before_.elements[map_.elements[after_.vertices[start].element]].vertices()) {
      const Segment old = segment(before_, v);
      if (is_on(old, edge.start) && is_on(old, edge.end)) return v;
    }
    return std::nullopt;
  }

 private:
  static Segment segment(const Model& model, VertexIndex start) {
    const auto place = [&](VertexIndex v) { return model.start_vertices[static_cast<std::size_t>(v.value)]; };
    return {place(start), place(model.vertices[start].next)};
  }

  bool is_on(const Segment& old, Point p) const {
    const Point along = old.end - old.start;
    const double share = std::clamp(dot(p - old.start, along) / dot(along, along), 0.0, 1.0);
    return distance(old.start + share * along, p) <= kOnEdge * before_.scale;
  }

  const SceneMap& map_;
  const Model& before_;
  const Model& after_;
};

/// The gap at which two faces were bonded; none where they were not.
class BondedFaces {
 public:
  explicit BondedFaces(const Bonds& bonds) {
    for (const auto& [facing, bond] : bonds) gaps_.emplace(std::minmax(facing.lower, facing.upper), bond.gap);
  }

  std::optional<double> gap(std::optional<VertexIndex> one, std::optional<VertexIndex> other) const {
    if (!one || !other) return std::nullopt;
    const auto found = gaps_.find(std::minmax(*one, *other));
    return found == gaps_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  std::map<std::pair<VertexIndex, VertexIndex>, double> gaps_;
};

// Faces whose joint is of another material now are bonded as it says; those that a mesh parts anew stay bonded, other
// new faces are not.
Bonds carried_bonds(const Bonds& bonds, const Names& names, const SceneMap& map, const StandardScene& before,
                    const Motion& carried, const StandardScene& after, double time) {
  const Edges edges(map, before, after);
  const BondedFaces faces(bonds);
  Bonds kept;
  for (const auto& [was, bond] : bonds)
    if (Facing facing = was; names.rename(facing) && !is_other_joint(facing, map, before, after))
      kept.emplace(facing, bond);
  const Scales scales = scales_of(after, loads_at(after, carried.q, time), carried.q, carried.v);
  for (const auto& [facing, bond] : bonds_at(after, carried.q, resting_touches(after, carried, scales)))
    if (is_other_joint(facing, map, before, after)) {
      kept.emplace(facing, bond);
    } else if (edges.is_new(facing.lower) || edges.is_new(facing.upper)) {
      const std::optional<double> gap = faces.gap(edges.before(facing.lower), edges.before(facing.upper));
      if (gap) kept.emplace(facing, Bond{*gap, bond.length});
    }
  return kept;
}

// Of every fixed point of elements that can move its place among them; below 0 of the others.
std::vector<int> places_among_held(const Model& model) {
  std::vector<int> places;
  int next = 0;
  for (const CarriedPoint& point : model.fixed_points)
    places.push_back(model.elements[point.element].can_move() ? next++ : -1);
  return places;
}

void carry_constraints(const StandardScene& before, const Motion& motion, const SceneMap& map,
                       const StandardScene& after, Motion& carried) {
  ConstraintMemory& constraints = carried.constraints;
  const Eigen::VectorXd longer = elongations(after.model, after.reference, carried.q);
  for (std::size_t i = 0; i < map.bolts.size(); ++i) {
    if (map.bolts[i] < 0) {
      const Bolt& bolt = after.model.bolts[i];
      constraints.bolt_forces[i] += bolt.stiffness * longer[static_cast<Eigen::Index>(i)];
      continue;
    }
    const auto old = static_cast<std::size_t>(map.bolts[i]);
    constraints.bolt_forces[i] = motion.constraints.bolt_forces[old];
    constraints.broken[i] = motion.constraints.broken[old];
  }
  const std::vector<int> was = places_among_held(before.model);
  const std::vector<int> is = places_among_held(after.model);
  for (std::size_t i = 0; i < map.fixed_points.size(); ++i) {
    if (map.fixed_points[i] < 0 || is[i] < 0) continue;
    const int old = was[static_cast<std::size_t>(map.fixed_points[i])];
    if (old >= 0) constraints.point_forces.segment<2>(2 * is[i]) = motion.constraints.point_forces.segment<2>(2 * old);
  }
}

}  // namespace

Model installed(Model model, const SceneMap& map, const StandardScene& before, const Motion& motion) {
  const Before then(before, motion, map);
  for (std::size_t i = 0; i < model.fixed_points.size(); ++i) {
    CarriedPoint& point = model.fixed_points[i];
    if (!point.holds_in_place) continue;
    point.curve.times = {0};
    point.curve.values = {map.fixed_points[i] < 0
                              ? then.place(point.element, point.start) - point.start
                              : before.model.fixed_points[static_cast<std::size_t>(map.fixed_points[i])].curve.at(0)};
  }
  for (std::size_t i = 0; i < model.bolts.size(); ++i) {
    Bolt& bolt = model.bolts[i];
    if (map.bolts[i] >= 0) {
      bolt.pretension = before.model.bolts[static_cast<std::size_t>(map.bolts[i])].pretension;
      continue;
    }
    const double present =
        distance(then.place(bolt.first.element, bolt.first.start), then.place(bolt.second.element, bolt.second.start));
    bolt.pretension -= bolt.stiffness * (present - bolt.start_length());
  }
  return model;
}

Motion carried_motion(const StandardScene& before, const Motion& motion, const SceneMap& map,
                      const StandardScene& after, double time) {
  Motion carried = start_motion(after);
  const BodiesBefore bodies{before.parts(), before.groups, motion, map.elements};
  for (const auto& group : after.groups) group->carry(after.parts(), bodies, carried);
  const Names names(map, before, after);
  carried.closed = carried_contacts(motion.closed, names);
  carried.bonds = carried_bonds(motion.bonds, names, map, before, carried, after, time);
  carry_constraints(before, motion, map, after, carried);
  return carried;
}

}  // namespace keyblock
