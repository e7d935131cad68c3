// Computes moduli of elements and finds boundary edges by position; see continuum.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/box.hpp"
#include "geometry/segment.hpp"
#include "material/material_stress.hpp"
#include "model/body_load.hpp"

namespace keyblock {
namespace {

// Cutting rounds crossings to some 1e-16 of the extent; the shortest edges of interest have 1e-8 of an element.
constexpr double kAlong = 1e-10;
// Share of the largest coordinate by which points of a file and of the cut round far from the origin.
constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();
constexpr double kInside = 1e-9;  // per size of an element: keeps a point on its own side of a crack

}  // namespace

int Continuum::material_number(int element) const {
  if (!element_materials.empty()) return element_materials[static_cast<std::size_t>(element)];
  const int body = manifold.elements[static_cast<std::size_t>(element)].body;
  return manifold.body_materials[static_cast<std::size_t>(body)];
}

const BlockMaterial& Continuum::material(int element) const {
  return materials[static_cast<std::size_t>(material_number(element))];
}

Point Continuum::force_at(int element, Point x) const {
  const BlockMaterial& of = material(element);
  const Point weight{of.horizontal_force, -of.unit_weight};
  return body_force ? weight + body_force(x) : weight;
}

Stress Continuum::initial_stress_at(int element, Point x) const {
  const BlockMaterial& of = material(element);
  const Stress stress = start_stress(of, of.stress_gradient, x.y, plane);
  if (!initial_stress) return stress;
  const Stress more = initial_stress(x);
  const Stress sum = with_across(in_plane(stress) + in_plane(more), stress, share_across(of, plane));
  if (!gives_initial_zz || plane == Plane::stress) return sum;
  return {sum.xx, sum.yy, sum.xy, stress.zz + more.zz};
}

ElasticLaw Continuum::law(int element) const {
  return laws.empty() ? ElasticLaw::st_venant_kirchhoff : laws[static_cast<std::size_t>(material_number(element))];
}

Eigen::Matrix3d Continuum::modulus(int element) const {
  return modulus_of(material(element), plane);
}

CoverBasis basis_of(const Continuum& continuum) {
  return {continuum.manifold, continuum.functions, continuum.tip_functions};
}

std::vector<AreaPoint> area_rule(const Manifold& manifold, int element, const ElementShape& shape, int degree) {
  const auto loops = manifold.polygon(manifold.elements[static_cast<std::size_t>(element)]);
  return shape.tip == nullptr ? polygon_rule(loops, degree)
                              : polygon_rule_about(shape.tip->tips, loops, shape.frame.size, degree);
}

std::vector<EdgePoint> edge_rule(const ElementSide& side, const ElementShape& shape, int count) {
  std::vector<EdgePoint> points;
  if (shape.tip == nullptr) {
    const double all = length(side.edge.end - side.edge.start);
    for (const GaussPoint& g : gauss_rule(count)) points.push_back({point_at(side.edge, g.at), all * g.weight});
    return points;
  }
  const Point inwards = (-kInside * shape.frame.size) * side.normal();
  for (const EdgePoint& p : edge_rule_about(shape.tip->tips, side.edge)) points.push_back({p.at + inwards, p.weight});
  return points;
}

Continuum continuum_of(Manifold manifold, const std::vector<BlockMaterial>& materials, const Settings& settings,
                       CoverFunctions functions) {
  Continuum continuum;
  continuum.manifold = std::move(manifold);
  for (int& material : continuum.manifold.body_materials)
    material = std::clamp(material, 0, static_cast<int>(materials.size()) - 1);
  continuum.materials = materials;
  for (BlockMaterial& material : continuum.materials) {
    const Eigen::Vector2d weight = weight_per_area(material, settings);
    material.horizontal_force = weight.x();
    material.unit_weight = -weight.y();
  }
  for (std::size_t i = 0; i < materials.size(); ++i)
    continuum.laws.push_back(settings.standard.elastic_law.of(static_cast<int>(i)));
  continuum.plane = settings.plane;
  continuum.functions = functions;
  return continuum;
}

Point ElementSide::normal() const {
  const Point along = edge.end - edge.start;
  return (1 / length(along)) * Point{along.y, -along.x};
}

std::vector<ElementSide> boundary_sides(const Manifold& manifold) {
  std::vector<ElementSide> sides;
  for (const SlotRange& loop : manifold.boundary_loops) {
    const auto edge_at = [&](int k) {
      return manifold.boundary_edges[static_cast<std::size_t>(loop.first + k % loop.size)];
    };
    const auto position = [&](int k) { return manifold.corners[static_cast<std::size_t>(edge_at(k).corner)].position; };
    for (int i = 0; i < loop.size; ++i) sides.push_back({edge_at(i).element, {position(i), position(i + 1)}});
  }
  return sides;
}

std::vector<Segment> pieces_of(const BoundaryPart& part) {
  std::vector<Segment> pieces;
  for (std::size_t k = 0; k + 1 < part.size(); ++k) pieces.push_back({part[k], part[k + 1]});
  return pieces;
}

double reach_of_chains(const Manifold& manifold) {
  Box box;
  for (const ElementCorner& corner : manifold.corners) box.add(corner.position);
  if (manifold.corners.empty()) return 0;
  const double farthest =
      std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  return kAlong * length(box.size()) + kRounding * farthest;
}

std::vector<ElementSide> sides_along(const Manifold& manifold, const BoundaryPart& part) {
  const double near = reach_of_chains(manifold);
  const std::vector<Segment> pieces = pieces_of(part);
  std::vector<ElementSide> sides;
  for (const ElementSide& side : boundary_sides(manifold))
    for (const Segment& covered : parts_along(side.edge, pieces, near)) sides.push_back({side.element, covered});
  return sides;
}

}  // namespace keyblock
