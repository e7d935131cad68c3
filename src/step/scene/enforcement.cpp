// Finds rings of blocks: a ring closes if a pair joins two blocks that are already connected.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/enforcement.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/union_find.hpp"
#include "geometry/segment.hpp"
#include "model/kinematics.hpp"
#include "step/newton/tolerances.hpp"

namespace keyblock {
namespace {

Point place_of(const Model& model, VertexIndex vertex) {
  return model.start_vertices[static_cast<std::size_t>(vertex.value)];
}

Segment edge_from(const Model& model, VertexIndex start) {
  return {place_of(model, start), place_of(model, model.vertices[start].next)};
}

bool has_corner_on(const Model& model, ElementIndex corners, ElementIndex edges, double tolerance) {
  for (VertexIndex corner : model.elements[corners].vertices())
    for (VertexIndex v : model.elements[edges].vertices())
      if (distance(edge_from(model, v), place_of(model, corner)) <= tolerance) return true;
  return false;
}

// Rows of points that depend on one another to this share have forces of their own: points of drawings are rounded.
constexpr double kDependent = 1e-4;
// Sine of the angle up to which faces are parallel.
constexpr double kParallel = 1e-3;

bool do_edges_cross(const Model& model, ElementIndex a, ElementIndex b) {
  for (VertexIndex one : model.elements[a].vertices())
    for (VertexIndex other : model.elements[b].vertices())
      if (meeting(edge_from(model, one), edge_from(model, other)) != keyblock::Meeting::none) return true;
  return false;
}

// Pairs with a corner of one on an edge of the other; blocks drawn over one another are in contact too.
std::vector<ElementPair> pairs_within(const Model& model, double tolerance) {
  State state;
  state.vertices.assign(model.start_vertices.begin(), model.start_vertices.end());
  std::vector<ElementPair> pairs = close_pairs(model, state, tolerance);
  std::erase_if(pairs, [&](const ElementPair& pair) {
    return !has_corner_on(model, pair.lower, pair.upper, tolerance) &&
           !has_corner_on(model, pair.upper, pair.lower, tolerance) && !do_edges_cross(model, pair.lower, pair.upper);
  });
  return pairs;
}

/// Point at which two blocks meet along faces.
struct Meeting {
  Point at;
  Point along;  ///< direction of the face, of length 1
  bool is_bonded = false;
  bool is_rough = false;
};

// Appends the corners of a block on the edges of another.
void add_corners_on(const Model& model, ElementIndex corners, ElementIndex edges, double tolerance,
                    std::vector<Meeting>& meetings) {
  for (VertexIndex corner : model.elements[corners].vertices())
    for (VertexIndex v : model.elements[edges].vertices()) {
      const Segment edge = edge_from(model, v);
      if (distance(edge, place_of(model, corner)) > tolerance) continue;
      const JointMaterial& joint = model.joint_material(model.vertices[model.vertices[v].next].joint_material);
      meetings.push_back({place_of(model, corner), (1 / distance(edge.start, edge.end)) * (edge.end - edge.start),
                          joint.has_strength(), joint.friction_angle_deg > 0});
    }
}

// Returns the ends of the stretches that two blocks share, each once a direction. Corners that meet share none.
std::vector<Meeting> meetings_of(const Model& model, const ElementPair& pair, double tolerance) {
  std::vector<Meeting> all;
  add_corners_on(model, pair.lower, pair.upper, tolerance, all);
  add_corners_on(model, pair.upper, pair.lower, tolerance, all);
  const auto is_along = [](const Meeting& a, const Meeting& b) {
    return std::abs(cross(a.along, b.along)) < kParallel;
  };
  const auto is_at = [&](const Meeting& a, const Meeting& b) { return distance(a.at, b.at) <= tolerance; };
  std::vector<Meeting> ends;
  for (const Meeting& one : all) {
    const bool has_other_end =
        std::ranges::any_of(all, [&](const Meeting& other) { return is_along(one, other) && !is_at(one, other); });
    const bool is_known = std::ranges::any_of(ends, [&](const Meeting& other) {
      return is_at(one, other) && (is_along(one, other) || (one.is_bonded && other.is_bonded));
    });
    if (has_other_end && !is_known) ends.push_back(one);
  }
  return ends;
}

// Returns true if blocks meet at more points than their unknowns can follow, and bonds, or also friction, hold some of
// them. Without springs the forces are then not determined: a block bonded on two sides, or on one beside a wall, can
// have any thrust.
bool are_held_redundantly(const Model& model, bool by_friction) {
  const double size = std::sqrt(model.mean_area);
  const double tolerance = tolerances::of_gaps::kDrawnTogether * size;
  Table<ElementIndex, Eigen::Index> first;
  Eigen::Index unknowns = 0;
  for (const Element& element : model.elements) {
    first.push_back(unknowns);
    if (element.can_move()) unknowns += static_cast<Eigen::Index>(element.basis->unknown_count());
  }
  std::vector<Eigen::RowVectorXd> rows;
  bool holds = false;
  for (const ElementPair& pair : pairs_within(model, tolerance)) {
    if (!model.elements[pair.lower].can_move() && !model.elements[pair.upper].can_move()) continue;
    for (const Meeting& meeting : meetings_of(model, pair, tolerance)) {
      Eigen::MatrixXd apart = Eigen::MatrixXd::Zero(2, unknowns);
      for (const auto& [e, sign] : {std::pair{pair.lower, 1.0}, {pair.upper, -1.0}}) {
        const Element& element = model.elements[e];
        if (!element.can_move()) continue;
        const auto count = static_cast<Eigen::Index>(element.basis->unknown_count());
        const Point offset = (1 / size) * (meeting.at - place_of(model, element.first_vertex));
        apart.middleCols(first[e], count) = sign * jacobian(*element.basis, Unknowns::Zero(count), offset);
      }
      rows.emplace_back(-meeting.along.y * apart.row(0) + meeting.along.x * apart.row(1));
      if (!meeting.is_bonded && !(by_friction && meeting.is_rough)) continue;
      rows.emplace_back(meeting.along.x * apart.row(0) + meeting.along.y * apart.row(1));
      holds = true;
    }
  }
  if (!holds) return false;
  Eigen::MatrixXd all(static_cast<Eigen::Index>(rows.size()), unknowns);
  for (std::size_t i = 0; i < rows.size(); ++i) all.row(static_cast<Eigen::Index>(i)) = rows[i];
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(all);
  factors.setThreshold(kDependent);
  return factors.rank() < all.rows();
}

// Up to this number of movable blocks multipliers serve even in a ring.
constexpr std::ptrdiff_t kFewBlocks = 8;
// In statics, friction in a ring counts as a bond if more blocks can move. On held slopes of 5 to 8 movable blocks
// multipliers found no forces in 13 of 15, and all of up to 3.
constexpr std::ptrdiff_t kVeryFewBlocks = 3;

std::ptrdiff_t movable_blocks(const Model& model) {
  return std::ranges::count_if(model.elements, &Element::can_move);
}

bool are_held_redundantly(const Model& model, const Settings& settings) {
  const bool by_friction = settings.standard.motion != MotionRule::dynamic && movable_blocks(model) > kVeryFewBlocks &&
                           has_ring(model, touching_pairs(model));
  return are_held_redundantly(model, by_friction);
}

bool is_automatic(Enforcement enforcement) {
  return enforcement == Enforcement::automatic;
}

}  // namespace

std::vector<ElementPair> touching_pairs(const Model& model) {
  return pairs_within(model, tolerances::of_gaps::kTouching * std::sqrt(model.mean_area));
}

bool has_ring(const Model& model, const std::vector<ElementPair>& touching) {
  const int held = static_cast<int>(model.elements.size());
  const auto node = [&](ElementIndex e) { return !model.elements[e].can_move() ? held : e.value; };
  std::set<std::pair<int, int>> joins;  // once, even if a block touches several fixed blocks
  for (const ElementPair& pair : touching) {
    const auto [lower, upper] = std::minmax({node(pair.lower), node(pair.upper)});
    if (lower != upper) joins.emplace(lower, upper);
  }
  UnionFind groups(model.elements.size() + 1);
  return std::ranges::any_of(joins, [&](const auto& join) { return !groups.unite(join.first, join.second); });
}

Settings with_enforcement_decided(Settings settings, const Model& model) {
  auto& [common, own] = settings.standard.enforcement;
  const bool is_asked = is_automatic(common) ||
                        std::ranges::any_of(own, [](const auto& material) { return is_automatic(material.second); });
  if (!is_asked) return settings;
  // Faces of many elements meet at more points than have independent forces.
  const bool needs_springs = settings.standard.impact == ImpactLaw::springs || model.shares_unknowns() ||
                             (movable_blocks(model) <= kFewBlocks ? are_held_redundantly(model, settings)
                                                                  : has_ring(model, touching_pairs(model)));
  const Enforcement decided = needs_springs ? Enforcement::penalty : Enforcement::lagrange;
  if (is_automatic(common)) common = decided;
  for (auto& [material, enforcement] : own)
    if (is_automatic(enforcement)) enforcement = decided;
  return settings;
}

std::string why_enforcement(const Model& model, const Settings& settings) {
  if (settings.standard.impact == ImpactLaw::springs) return "springs stop blocks that meet";
  if (model.shares_unknowns()) return "faces of NMM bodies";
  if (movable_blocks(model) <= kFewBlocks)
    return are_held_redundantly(model, settings) ? "bonds or friction hold blocks at more points than they can follow"
                                                 : fmt::format("at most {} blocks can move", kFewBlocks);
  return has_ring(model, touching_pairs(model)) ? "blocks in contact form a ring" : "no blocks in contact form a ring";
}

}  // namespace keyblock
