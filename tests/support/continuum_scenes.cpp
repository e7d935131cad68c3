// Cuts bodies and computes exact fields and norms; see continuum_scenes.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/continuum_scenes.hpp"

#include <algorithm>
#include <cmath>

#include "cut/covers/cut_cover.hpp"
#include "cut/covers/to_cover.hpp"
#include "cut/mesh/background_mesh.hpp"
#include "geometry/quadrature.hpp"

namespace keyblock {

Manifold cut_body(const std::vector<std::vector<Point>>& loops, const MeshSetting& mesh) {
  BodyGraph graph;
  graph.materials = {0};
  Box box;
  for (const std::vector<Point>& loop : loops) {
    const int first = static_cast<int>(graph.nodes.size());
    const int count = static_cast<int>(loop.size());
    for (int i = 0; i < count; ++i) {
      graph.nodes.push_back(loop[static_cast<std::size_t>(i)]);
      graph.pieces.push_back({first + i, first + (i + 1) % count, false, 0, -1, 0});
      box.add(loop[static_cast<std::size_t>(i)]);
    }
  }
  const RegularMesh regular{mesh.h, mesh.h / mesh.side_over_row, mesh.through, mesh.angle};
  return cut_cover(graph, regular_triangles(box, regular));
}

std::vector<Point> rectangle_corners(Point low, Point high) {
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

BoundaryPart closed(std::vector<Point> chain) {
  chain.push_back(chain.front());
  return chain;
}

BlockMaterial elastic_material(double youngs_modulus, double poissons_ratio) {
  BlockMaterial material;
  material.density = 1;
  material.youngs_modulus = youngs_modulus;
  material.poissons_ratio = poissons_ratio;
  return material;
}

FieldErrors errors_of(const Continuum& continuum, const ContinuumSolution& solution, const ExactField& exact) {
  double difference = 0, whole = 0, energy_difference = 0, energy = 0, largest = 0, largest_exact = 0;
  for (int e = 0; e < solution.basis.element_count(); ++e) {
    const Eigen::Matrix3d modulus = continuum.modulus(e);
    const auto loops = continuum.manifold.polygon(continuum.manifold.elements[static_cast<std::size_t>(e)]);
    for (const AreaPoint& p : polygon_rule(loops, 2 * solution.basis.degree() + 4)) {
      const Point u = exact.displacement(p.at);
      const Point off = solution.displacement(e, p.at) - u;
      const Eigen::Matrix2d g = exact.gradient(p.at);
      const Eigen::Vector3d strain(g(0, 0), g(1, 1), g(0, 1) + g(1, 0));
      const Eigen::Vector3d strain_off = solution.strain(e, p.at) - strain;
      difference += p.weight * dot(off, off);
      whole += p.weight * dot(u, u);
      energy_difference += p.weight * strain_off.dot(modulus * strain_off);
      energy += p.weight * strain.dot(modulus * strain);
      largest = std::max(largest, length(off));
      largest_exact = std::max(largest_exact, length(u));
    }
  }
  return {std::sqrt(std::abs(difference) / whole), std::sqrt(std::abs(energy_difference) / energy),
          largest / largest_exact};
}

Point displacement_at(const Continuum& continuum, const ContinuumSolution& solution, Point x) {
  return solution.displacement(element_at(continuum.manifold, 0, x), x);
}

Stress stress_at(const Continuum& continuum, const ContinuumSolution& solution, Point x) {
  return stress_at(continuum, solution, element_at(continuum.manifold, 0, x), x);
}

}  // namespace keyblock
