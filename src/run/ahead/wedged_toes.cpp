// Compares the direction in which a corner would slide with the edges on which it lies.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/ahead/wedged_toes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "base/sentences/sentences.hpp"
#include "geometry/segment.hpp"
#include "step/newton/tolerances.hpp"
#include "step/scene/enforcement.hpp"

namespace keyblock {
namespace {

// Directions within this sine of a line run along it: drawings have four digits.
constexpr double kAlongToe = 0.01;
// A face whose friction alone gives this factor is not expected to slide.
constexpr double kHeld = 2;

/// An edge of a block; the block lies on its left.
struct ToeEdge {
  Segment line;
  int joint_material = 0;

  Point along() const { return (1 / distance(line.start, line.end)) * (line.end - line.start); }
  Point outward() const { return {along().y, -along().x}; }
};

struct Toe {
  ElementIndex block;
  Point corner;
  double dip = 0;  ///< of the face on which it would slide
};

class Toes {
 public:
  explicit Toes(const Scene& scene)
      : model_(scene.model),
        near_(tolerances::of_gaps::kDrawnTogether * std::sqrt(scene.model.mean_area)),
        down_((1 / length(scene.settings.gravity)) * scene.settings.gravity),
        neighbours_(static_cast<std::size_t>(scene.model.elements.size())) {
    if (!has_sharp_corners()) return;  // a wall of bricks pays for no search of pairs
    for (const ElementPair& pair : touching_pairs(model_)) {
      neighbours_[number(pair.lower)].push_back(pair.upper);
      neighbours_[number(pair.upper)].push_back(pair.lower);
    }
  }

  std::vector<Toe> found() const {
    std::vector<Toe> toes;
    for (ElementIndex e : indices(model_.elements)) {
      if (!model_.elements[e].can_move()) continue;
      for (VertexIndex v : model_.elements[e].vertices())
        if (const auto dip = dip_of_toe(e, edge_from(v), edge_from(model_.vertices[v].next)))
          toes.push_back({e, place(model_.vertices[v].next), *dip});
    }
    return toes;
  }

 private:
  static std::size_t number(ElementIndex e) { return static_cast<std::size_t>(e.value); }
  Point place(VertexIndex v) const { return model_.start_vertices[static_cast<std::size_t>(v.value)]; }
  ToeEdge edge_from(VertexIndex v) const {
    const VertexIndex end = model_.vertices[v].next;
    return {{place(v), place(end)}, model_.vertices[end].joint_material};
  }

  static bool is_sharp(const ToeEdge& before, const ToeEdge& after) {
    return dot(before.along(), after.along()) < -kAlongToe;
  }

  bool has_sharp_corners() const {
    for (const Element& element : model_.elements)
      for (VertexIndex v : element.vertices())
        if (element.can_move() && is_sharp(edge_from(v), edge_from(model_.vertices[v].next))) return true;
    return false;
  }

  // Returns the dip of a face on which a sharp corner, where two edges of a block meet, would slide into a floor.
  std::optional<double> dip_of_toe(ElementIndex block, const ToeEdge& before, const ToeEdge& after) const {
    if (!is_sharp(before, after)) return std::nullopt;
    const Point corner = before.line.end;
    const auto dip_on = [&](const ToeEdge& lower, const ToeEdge& face, Point slide) -> std::optional<double> {
      const double dip = std::asin(std::clamp(dot(slide, down_), -1.0, 1.0));
      if (std::sin(dip) <= kAlongToe || dot(lower.outward(), down_) <= kAlongToe) return std::nullopt;
      const double friction = model_.joint_material(lower.joint_material).friction_tangent();
      const bool slides = friction < kHeld * std::tan(dip) && is_covered(lower, block, corner) &&
                          !is_covered(face, block, corner) && is_stopped(block, corner, slide);
      return slides ? std::optional(dip) : std::nullopt;
    };
    if (const auto dip = dip_on(before, after, before.along())) return dip;
    return dip_on(after, before, -1.0 * after.along());
  }

  // Returns true if a neighbour lies along an edge of a block, at one of its points.
  bool is_covered(const ToeEdge& edge, ElementIndex block, Point at) const {
    std::vector<Segment> others;
    for (ElementIndex neighbour : neighbours_[number(block)])
      for (VertexIndex v : model_.elements[neighbour].vertices()) others.push_back(edge_from(v).line);
    return std::ranges::any_of(parts_along(edge.line, others, near_), [&](const Segment& part) {
      return distance(part.start, part.end) > near_ && distance(part, at) <= near_;
    });
  }

  // Returns true if a corner lies on a free edge of a neighbour and would slide into it.
  bool is_stopped(ElementIndex block, Point corner, Point slide) const {
    for (ElementIndex neighbour : neighbours_[number(block)])
      for (VertexIndex v : model_.elements[neighbour].vertices()) {
        const ToeEdge edge = edge_from(v);
        if (distance(edge.line, corner) <= near_ && dot(slide, edge.outward()) < -kAlongToe &&
            !is_covered(edge, neighbour, corner))
          return true;
      }
    return false;
  }

  const Model& model_;
  double near_;
  Point down_;
  std::vector<std::vector<ElementIndex>> neighbours_;
};

}  // namespace

Warnings wedged_toes(const Scene& scene, const Place& place) {
  if (scene.settings.dynamics != Dynamics::standard || scene.is_untouched || length(scene.settings.gravity) == 0)
    return {};
  const std::vector<Toe> toes = Toes(scene).found();
  if (toes.empty()) return {};
  Facts facts{{{"count", toes.size()}, {"dip_deg", toes.front().dip * 180 / std::numbers::pi}}};
  facts.texts = {{"toes", toes.size() == 1 ? "a sharp toe rests" : fmt::format("{} sharp toes rest", toes.size())}};
  for (const Toe& toe : toes) {
    facts.elements.push_back(scene.model.number_of(toe.block));
    facts.points.push_back({toe.corner.x, toe.corner.y});
  }
  return {warning_of({"toe_wedged", std::move(facts)}, place)};
}

}  // namespace keyblock
