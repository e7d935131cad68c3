// Corners, centroids and measured points of a static field.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/static_places.hpp"

#include "model/kinematics.hpp"

namespace keyblock {

void put_places(const Scene& scene, const StaticField& field, State& state) {
  const Model& model = scene.model;
  Table<VertexIndex, Point> start;
  Table<VertexIndex, Point> vertices;
  for (const VertexIndex v : indices(model.vertices)) {
    start.push_back(model.start_vertices[static_cast<std::size_t>(v.value)]);
    vertices.push_back(field.place(model.vertices[v].element, start[v]));
  }
  state.elements = Table<ElementIndex, ElementState>();
  for (const ElementIndex e : indices(model.elements)) {
    const Point centroid = place(model, start, e, scene.settings).centroid;
    const Unknowns none = Unknowns::Zero(model.elements[e].basis->unknown_count());
    state.elements.push_back({field.place(e, centroid), place(model, vertices, e, scene.settings).moments, none, none,
                              field.stress(e, centroid), 0});
  }
  state.vertices = std::move(vertices);
  state.measured_points.clear();
  for (const CarriedPoint& point : model.measured_points) {
    const Point now = field.place(point.element, point.start);
    state.measured_points.push_back({now, now - point.start});
  }
}

}  // namespace keyblock
