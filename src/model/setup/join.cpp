// Shifts numbers, and recomputes scale and mean area.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setup/join.hpp"

#include "model/setup/build.hpp"

namespace keyblock {
namespace {

VertexIndex moved_on(VertexIndex v, int by) {
  return v ? VertexIndex{v.value + by} : v;
}

void add_points(std::vector<CarriedPoint>& points, const std::vector<CarriedPoint>& more, int elements) {
  for (CarriedPoint point : more) {
    point.element.value += elements;
    points.push_back(std::move(point));
  }
}

}  // namespace

Model joined(Model blocks, const Model& bodies) {
  const int elements = blocks.elements.end_index().value;
  const int vertices = blocks.vertices.end_index().value;
  const double area = blocks.mean_area * elements + bodies.mean_area * bodies.elements.end_index().value;
  for (Element element : bodies.elements) {
    element.first_vertex = moved_on(element.first_vertex, vertices);
    element.end_vertex = moved_on(element.end_vertex, vertices);
    for (int& cover : element.covers) cover += elements;  // after the one cover of each block

    blocks.elements.push_back(element);
  }
  for (Vertex vertex : bodies.vertices) {
    vertex.element.value += elements;
    for (VertexIndex* v : {&vertex.next, &vertex.previous, &vertex.boundary_next, &vertex.boundary_previous})
      *v = moved_on(*v, vertices);
    blocks.vertices.push_back(vertex);
  }
  blocks.start_vertices.insert(blocks.start_vertices.end(), bodies.start_vertices.begin(), bodies.start_vertices.end());
  blocks.nodes.resize(static_cast<std::size_t>(elements));
  blocks.nodes.insert(blocks.nodes.end(), bodies.nodes.begin(), bodies.nodes.end());
  add_points(blocks.fixed_points, bodies.fixed_points, elements);
  add_points(blocks.loading_points, bodies.loading_points, elements);
  add_points(blocks.measured_points, bodies.measured_points, elements);
  blocks.continuum = bodies.continuum;
  blocks.scale = scale_of(blocks.start_vertices);
  blocks.mean_area = area / blocks.elements.end_index().value;
  return blocks;
}

}  // namespace keyblock
