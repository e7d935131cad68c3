// Evaluates operators and polygon integrals of an element at its present vertices, and finds impossible states.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/state.hpp"

#include <fmt/format.h>

#include <cmath>
#include <span>

namespace keyblock {

DisplacementOperator basis_at(const Model& model, const State& state, ElementIndex element, Point x) {
  return model.elements[element].basis->at(x - state.elements[element].centroid);
}

Placement place(const Model& model, const Table<VertexIndex, Point>& vertices, ElementIndex index,
                const Settings& settings) {
  const Element& element = model.elements[index];
  // An origin near the polygon keeps the digits of a scene far from the origin; the Berkeley program does not use one.
  const Point origin = settings.quirks.moments_about_origin ? Point{} : vertices[element.first_vertex];
  const std::span<const Point> points(&vertices[element.first_vertex],
                                      static_cast<std::size_t>(element.vertices().size()));
  Moments sum;
  std::size_t first = 0;
  for (int size : element.loop_sizes) {
    sum += moments(points.subspan(first, static_cast<std::size_t>(size)), origin);
    first += static_cast<std::size_t>(size);
  }
  const double x = sum.x / sum.area;
  const double y = sum.y / sum.area;
  // Shifting theorem: second moments about the centroid.
  return {origin + Point{x, y}, {sum.area, 0, 0, sum.xx - x * sum.x, sum.yy - y * sum.y, sum.xy - x * sum.y}};
}

StartPlaces places_of(const State& state) {
  StartPlaces places{state.vertices, {}};
  places.elements.reserve(state.elements.size());
  for (const ElementState& element : state.elements) places.elements.push_back({element.centroid, element.moments});
  return places;
}

std::optional<ElementIndex> impossible(const State& state) {
  for (ElementIndex e : indices(state.elements)) {
    const ElementState& now = state.elements[e];
    const Stress& stress = now.stress;
    const double sum = now.centroid.x + now.centroid.y + stress.xx + stress.yy + stress.xy + stress.zz + now.rotation +
                       now.last_step.sum();
    if (!std::isfinite(sum) || !(now.moments.area > 0)) return e;
  }
  return std::nullopt;
}

Unknowns end_velocity(const ElementState& element, const State& state, const Settings& settings, int material) {
  const double carry = settings.velocity_carry_over.of(material);
  if (state.step == 0 || carry == 0) return carry * element.velocity;
  if (!settings.quirks.velocity_from_coming_step) return element.velocity;
  return 2 / state.dt * element.last_step - carry * element.velocity;
}

}  // namespace keyblock
