// Builds the model from elements on covers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setup/from_manifold.hpp"

#include "geometry/polygon.hpp"
#include "model/setup/build.hpp"

namespace keyblock {
namespace {

// A corner of the mesh describes the edge that leaves it, one of the model the edge that arrives.
std::vector<Corner> corners_of(std::span<const ElementCorner> loop) {
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const ElementCorner& before = loop[i == 0 ? loop.size() - 1 : i - 1];
    corners.push_back({loop[i].position, before.joint_material, before.neighbour >= 0});
  }
  return corners;
}

class Builder {
 public:
  Builder(const Manifold& manifold, Model& model)
      : manifold_(manifold), model_(model), vertex_of_corner_(manifold.corners.size()) {}

  void run() {
    for (const PhysicalCover& cover : manifold_.covers)
      model_.nodes.push_back(manifold_.mesh.nodes[static_cast<std::size_t>(cover.node)]);
    for (const ManifoldElement& element : manifold_.elements) add(element);
    for (Vertex& vertex : model_.vertices) vertex.boundary_next = vertex.boundary_previous = {};
    for (const SlotRange& loop : manifold_.boundary_loops) join(loop);
  }

 private:
  void add(const ManifoldElement& element) {
    const int material = manifold_.body_materials[static_cast<std::size_t>(element.body)];
    begin_element(model_, material, fixed_basis(), {element.covers.begin(), element.covers.end()});
    add(element.outer);
    for (const SlotRange& hole : manifold_.holes_of(element)) add(hole);
  }

  void add(const SlotRange& loop) {
    for (int i = 0; i < loop.size; ++i)
      vertex_of_corner_[static_cast<std::size_t>(loop.first + i)] = {model_.vertices.end_index().value + i};
    add_loop(model_, corners_of(manifold_.loop(loop)));
  }

  void join(const SlotRange& loop) {
    for (int i = 0; i < loop.size; ++i) {
      const VertexIndex here = vertex_at(loop.first + i);
      const VertexIndex next = vertex_at(loop.first + (i + 1) % loop.size);
      model_.vertices[here].boundary_next = next;
      model_.vertices[next].boundary_previous = here;
    }
  }

  VertexIndex vertex_at(int edge) const {
    const int corner = manifold_.boundary_edges[static_cast<std::size_t>(edge)].corner;
    return vertex_of_corner_[static_cast<std::size_t>(corner)];
  }

  const Manifold& manifold_;
  Model& model_;
  std::vector<VertexIndex> vertex_of_corner_;
};

std::vector<CarriedPoint> carried_elements(const std::vector<CoverPoint>& points,
                                           const std::vector<TimeCurve>& curves) {
  std::vector<CarriedPoint> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    result.push_back({points[i].position, {points[i].element}, i < curves.size() ? curves[i] : TimeCurve{}});
  return result;
}

double mean_area_of_elements(const Manifold& manifold) {
  double sum = 0;
  for (const ManifoldElement& element : manifold.elements)
    for (const std::vector<Point>& loop : manifold.polygon(element)) sum += area(loop);
  return sum / static_cast<double>(manifold.elements.size());
}

}  // namespace

Model model_from_manifold(const Manifold& manifold, const ElementPoints& points, const Analysis& analysis) {
  Model model;
  model.block_materials = analysis.block_materials;
  model.joint_materials = analysis.joint_materials;
  Builder(manifold, model).run();
  model.fixed_points = carried_elements(points.fixed, analysis.fixed_point_motions);
  model.loading_points = carried_elements(points.loading, analysis.point_loads);
  model.measured_points = carried_elements(points.measured, {});
  model.scale = scale_of(model.start_vertices);
  model.mean_area = mean_area_of_elements(manifold);
  return model;
}

}  // namespace keyblock
