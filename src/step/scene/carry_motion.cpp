// Transfers the motion element by element, then contact by contact.
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

// Tolerance, relative to the scene's scale, of mesh points on the edge of their block: round-off of cutting.
constexpr double kOnEdge = 1e-9;

/// Locates material points of the later scene: each moves with the element that it was part of.
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

/// Maps vertices of the earlier scene to the later one, and contacts and bonds with them.
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

  /// Returns false if one of its edges is gone.
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

// An edge may have another joint material now.
ClosedContacts carried_contacts(const ClosedContacts& closed, const Names& names, const StandardScene& after,
                                const UnknownsTable& q) {
  Touches touches;
  std::vector<ContactMemory> memories;
  for (const ClosedContact& contact : closed.all())
    if (const std::optional<Touch> touch = names.of(contact.touch)) {
      touches.push_back(*touch);
      memories.push_back(contact.memory);
    }
  name_joints(touches, after.model, vertices_at(after.model, after.reference, q));
  std::vector<ClosedContact> kept;
  for (std::size_t i = 0; i < touches.size(); ++i) kept.push_back({touches[i], memories[i]});
  return ClosedContacts(std::move(kept));
}

/// Returns true if an edge that existed before now has another joint material.
bool is_other_joint(const Facing& facing, const SceneMap& map, const StandardScene& before,
                    const StandardScene& after) {
  const auto is_other = [&](VertexIndex start) {
    const VertexIndex end = after.model.vertices[start].next;
    if (!map.vertices[start] || !map.vertices[end]) return false;
    return after.model.vertices[end].joint_material != before.model.vertices[map.vertices[end]].joint_material;
  };
  return is_other(facing.lower) || is_other(facing.upper);
}

/// Maps edges of the later scene to those of the earlier one on which they lie: a mesh divides the edges of its block.
class Edges {
 public:
  Edges(const SceneMap& map, const StandardScene& before, const StandardScene& after)
      : map_(map), before_(before.model), after_(after.model) {}

  bool is_new(VertexIndex start) const {
    const VertexIndex end = after_.vertices[start].next;
    return !map_.vertices[start] || !map_.vertices[end] ||
           before_.vertices[map_.vertices[start]].next != map_.vertices[end];
  }

  /// Returns no vertex if the edge lies on no edge of the element that its own was cut from.
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

/// Finds the gap at which two faces were bonded; empty if they were not.
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

// Faces with a changed joint material get the bonds of the new one. Faces newly divided by a mesh stay bonded; other
// new faces have no bonds.
Bonds carried_bonds(const Bonds& bonds, const Names& names, const SceneMap& map, const StandardScene& before,
                    const Motion& carried, const StandardScene& after, double time) {
  const Edges edges(map, before, after);
  const BondedFaces faces(bonds);
  Bonds kept;
  for (const auto& [was, bond] : bonds)
    if (Facing facing = was; names.rename(facing) && !is_other_joint(facing, map, before, after))
      kept.emplace(facing, bond);
  const Scales scales = scales_at(after, carried, time);
  for (const auto& [facing, bond] : bonds_at(after, carried, scales))
    if (is_other_joint(facing, map, before, after)) {
      kept.emplace(facing, bond);
    } else if (edges.is_new(facing.lower) || edges.is_new(facing.upper)) {
      const std::optional<double> gap = faces.gap(edges.before(facing.lower), edges.before(facing.upper));
      if (gap) kept.emplace(facing, Bond{*gap, bond.length});
    }
  return kept;
}

// Returns, per fixed point, its index among those of movable elements; negative for the others.
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
  carried.closed = carried_contacts(motion.closed, names, after, carried.q);
  carried.bonds = carried_bonds(motion.bonds, names, map, before, carried, after, time);
  carry_constraints(before, motion, map, after, carried);
  return carried;
}

}  // namespace keyblock
