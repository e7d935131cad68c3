// Builds bodies on rotated and shifted meshes, and measures the errors of their solutions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "step/bodies/linear_static.hpp"

namespace keyblock {

/// Triangles of side `h` in rows rotated by `angle` (rad), a node at `through`; equilateral where `side_over_row` is
/// 2/√3.
struct MeshSetting {
  double h = 1;
  double angle = 10 * std::numbers::pi / 180;
  Point through{0.0137, 0.0071};
  double side_over_row = 1.1547005383792515;
};

/// Returns one body of material 0 within closed chains (outer counter-clockwise, holes clockwise), cut from the mesh.
Manifold cut_body(const std::vector<std::vector<Point>>& loops, const MeshSetting& mesh);

/// Returns the corners of a rectangle, counter-clockwise from the lower left.
std::vector<Point> rectangle_corners(Point low, Point high);

/// Returns the chain with its first point repeated at the end: all of the boundary.
BoundaryPart closed(std::vector<Point> chain);

BlockMaterial elastic_material(double youngs_modulus, double poissons_ratio);

/// Displacement and its gradient, row i: (∂u_i/∂x, ∂u_i/∂y).
struct ExactField {
  std::function<Point(Point)> displacement;
  std::function<Eigen::Matrix2d(Point)> gradient;
};

/// A displacement to prescribe, independent of the direction of the boundary.
inline std::function<Point(Point, Point)> at_any_normal(std::function<Point(Point)> displacement) {
  return [displacement = std::move(displacement)](Point x, Point) { return displacement(x); };
}

/// Errors relative to the norms of the exact field.
struct FieldErrors {
  double l2 = 0;
  double energy = 0;
  double largest = 0;  ///< of the displacement at the points of quadrature, over its largest value there
};
FieldErrors errors_of(const Continuum& continuum, const ContinuumSolution& solution, const ExactField& exact);

/// Stress at a point of body 0.
Point displacement_at(const Continuum& continuum, const ContinuumSolution& solution, Point x);
Stress stress_at(const Continuum& continuum, const ContinuumSolution& solution, Point x);

inline constexpr CoverFunctions kAllCoverFunctions[] = {CoverFunctions::constant, CoverFunctions::derived,
                                                        CoverFunctions::linear, CoverFunctions::quadratic};

}  // namespace keyblock
