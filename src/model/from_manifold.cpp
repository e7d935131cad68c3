// Builds the model from elements on covers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/from_manifold.hpp"

#include "geometry/polygon.hpp"
#include "model/build.hpp"

namespace keyblock {
namespace {

// A corner of the mesh speaks of the edge that leaves it, one of the model of the edge that arrives.
std::vector<Corner> corners_of(std::span<const ElementCorner> loop) {
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const ElementCorner& before = loop[i == 0 ? loop.size() - 1 : i - 1];
    corners.push_back({loop[i].position, before.joint_material, before.neighbour >= 0});
  }
  return corners;
}

void add_element(Model& model, const Manifold& manifold, const ManifoldElement& element) {
  const int material = manifold.body_materials[static_cast<std::size_t>(element.body)];
  begin_element(model, material, fixed_basis(), {element.covers.begin(), element.covers.end()});
  add_loop(model, corners_of(manifold.loop(element.outer)));
  for (const SlotRange& hole : manifold.holes_of(element)) add_loop(model, corners_of(manifold.loop(hole)));
}

std::vector<CarriedPoint> carried(const std::vector<CoverPoint>& points, const std::vector<TimeCurve>& curves) {
  std::vector<CarriedPoint> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    result.push_back({points[i].position, {points[i].element}, i < curves.size() ? curves[i] : TimeCurve{}});
  return result;
}

double mean_area_of(const Manifold& manifold) {
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
  for (const ManifoldElement& element : manifold.elements) add_element(model, manifold, element);
  model.fixed_points = carried(points.fixed, analysis.fixed_point_motions);
  model.loading_points = carried(points.loading, analysis.point_loads);
  model.measured_points = carried(points.measured, {});
  model.scale = scale_of(model.start_vertices);
  model.mean_area = mean_area_of(manifold);
  return model;
}

}  // namespace keyblock
