// Bodies on covers with what holds and loads them: the problem of linear elasticity that continuum tests state.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "geometry/tip_rule.hpp"
#include "model/cover_basis.hpp"
#include "problem/analysis.hpp"
#include "problem/manifold.hpp"
#include "result/force_balance.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// A part of the boundary of bodies, named by an open chain of points that it runs along.
using BoundaryPart = std::vector<Point>;

/// Force per length of the boundary; `normal` points out of the body.
struct Traction {
  BoundaryPart along;
  std::function<Point(Point x, Point normal)> force;
};

struct PrescribedDisplacement {
  BoundaryPart along;
  Held held = Held::both;
  std::function<Point(Point x, Point normal)> value;
};

struct PointForce {
  int element = 0;
  Point at;
  Point force;
};

/// Holds one direction (of length 1) of a point. As the only support of a body whose loads are in equilibrium it
/// carries nothing.
struct PointSpring {
  int element = 0;
  Point at;
  Point direction;
  double stiffness = 0;  ///< force / length
};

struct Continuum {
  Manifold manifold;
  std::vector<BlockMaterial> materials;     ///< `manifold.body_materials` are places in it
  std::vector<int> element_materials = {};  ///< of each element, a place in `materials`; none: that of its body
  std::vector<ElasticLaw> laws = {};        ///< one a material; none: that of St. Venant and Kirchhoff
  Plane plane = Plane::stress;
  CoverFunctions functions = CoverFunctions::derived;
  TipFunctionPlan tip_functions = {};
  std::function<Point(Point x)> body_force;  ///< force / area, beside the weight of the materials; may be empty
  std::function<Stress(Point x)>
      initial_stress;             ///< before any displacement, beside that of the materials; may be empty
  bool gives_initial_zz = false;  ///< `initial_stress` does; else the law says what goes with it across the plane
  std::vector<Traction> tractions;
  std::vector<PrescribedDisplacement> prescribed;
  std::vector<PointForce> point_forces;
  std::vector<PointSpring> point_springs;
  bool faces_touch = false;            ///< those of cracks press and rub in linear statics; else they pass each other
  std::vector<CrackPlan> cracks = {};  ///< of the case file: a run then reports the stress intensity of all tips

  /// A place in `materials`.
  int material_number(int element) const;
  const BlockMaterial& material(int element) const;
  ElasticLaw law(int element) const;
  /// D, 3 × 3, of an element.
  Eigen::Matrix3d modulus(int element) const;
  /// Force / area: weight and push of the element's material, and `body_force`.
  Point force_at(int element, Point x) const;
  /// That of the element's material, linear in y, and `initial_stress`.
  Stress initial_stress_at(int element, Point x) const;
};

/// The functions of the bodies' elements.
CoverBasis basis_of(const Continuum& continuum);

/// Points of an element, exact to `degree` where its functions are polynomials, else fit for near-tip functions.
std::vector<AreaPoint> area_rule(const Manifold& manifold, int element, const ElementShape& shape, int degree);

/// Bodies on covers of a run in steps: materials weigh as `weight_per_area` says, those that do not exist are the
/// nearest that do.
Continuum continuum_of(Manifold manifold, const std::vector<BlockMaterial>& materials, const Settings& settings,
                       CoverFunctions functions);

/// An edge of an element on the boundary, or a part of one; the element lies to its left.
struct ElementSide {
  int element = 0;
  Segment edge;

  Point normal() const;  ///< outward, of length 1
};

/// Points along an edge: `count` of Gauss, or, where functions are no polynomials, closer near the tip and just inside
/// the element, which says on which face of the crack they lie.
std::vector<EdgePoint> edge_rule(const ElementSide& side, const ElementShape& shape, int count);

/// The boundary edges of a manifold, each with its element.
std::vector<ElementSide> boundary_sides(const Manifold& manifold);

/// The pieces of a chain.
std::vector<Segment> pieces_of(const BoundaryPart& part);

/// The distance within which a chain runs along the boundary: 1e-10 of the manifold's extent.
double reach_of_chains(const Manifold& manifold);

/// The boundary along a chain: edges, cut where the chain begins or ends inside one, both sides of a joint. What the
/// chain passes twice is there once. All that goes by chains (tractions, prescribed displacements) goes by these.
std::vector<ElementSide> sides_along(const Manifold& manifold, const BoundaryPart& part);

}  // namespace keyblock
