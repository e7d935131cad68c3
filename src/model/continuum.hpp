// Bodies on covers with what holds and loads them: the problem of linear elasticity that continuum tests state.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "model/cover_basis.hpp"
#include "model/settings.hpp"
#include "problem/analysis.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// A part of the boundary of bodies, named by an open chain of points that it runs along.
using BoundaryPart = std::vector<Point>;

/// Force per length of the boundary; `normal` points out of the body.
struct Traction {
  BoundaryPart along;
  std::function<Point(Point x, Point normal)> force;
};

/// Which component of the displacement is prescribed; `normal` with the value 0 is a line of symmetry.
enum class Held { both, normal, x, y };

struct PrescribedDisplacement {
  BoundaryPart along;
  Held held = Held::both;
  std::function<Point(Point x)> value;
};

struct PointForce {
  int element = 0;
  Point at;
  Point force;
};

/// Holds one direction (of length 1) of a point. As the only support of a body whose loads are in equilibrium it carries nothing.
struct PointSpring {
  int element = 0;
  Point at;
  Point direction;
  double stiffness = 0;  ///< force / length
};

struct Continuum {
  Manifold manifold;
  std::vector<BlockMaterial> materials;  ///< `manifold.body_materials` are places in it
  Plane plane = Plane::stress;
  CoverFunctions functions = CoverFunctions::derived;
  std::function<Point(Point x)> body_force;  ///< force / area; may be empty
  std::vector<Traction> tractions;
  std::vector<PrescribedDisplacement> prescribed;
  std::vector<PointForce> point_forces;
  std::vector<PointSpring> point_springs;

  const BlockMaterial& material(int element) const;
  /// D, 3 × 3, of an element.
  Eigen::Matrix3d modulus(int element) const;
};

/// An edge of an element on the boundary; the element lies to its left.
struct ElementSide {
  int element = 0;
  Segment edge;

  Point normal() const;  ///< outward, of length 1
};

/// The boundary edges along a chain: both sides of it where it is a joint. "Along" is within 1e-10 of the manifold's extent.
std::vector<ElementSide> sides_along(const Manifold& manifold, const BoundaryPart& part);

}  // namespace keyblock
