// Drops straight vertices, refuses reflex ones.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/outline.hpp"

namespace keyblock {
namespace {

// Sine of the turn below which a vertex lies on a straight edge. Cutting leaves vertices where joints meet an edge; drawings
// carry ten digits, so their turn is far below this, and a corner of less than 0.006 degrees is none to the eye.
constexpr double kStraightSine = 1e-4;

double sine_of_turn(const Model& model, VertexIndex v) {
  const auto at = [&](VertexIndex i) { return model.start_vertices[static_cast<std::size_t>(i.value)]; };
  const Point arriving = at(v) - at(model.vertices[v].previous);
  const Point leaving = at(model.vertices[v].next) - at(v);
  return cross(arriving, leaving) / (length(arriving) * length(leaving));
}

}  // namespace

Outline convex_outline(const Model& model, ElementIndex e) {
  const Element& element = model.elements[e];
  if (element.loop_sizes.size() > 1) return {};
  Outline corners;
  for (VertexIndex v : element.vertices()) {
    const double sine = sine_of_turn(model, v);
    if (sine < -kStraightSine) return {};
    if (sine > kStraightSine) corners.push_back(v);
  }
  return corners;
}

}  // namespace keyblock
