// Holds NMM bodies with their supports and loads: a problem of linear elasticity.
// Theory: docs/theory/08-manifold-method.md.
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

/// Part of the boundary of bodies, given by an open chain of points along it.
using BoundaryPart = std::vector<Point>;

/// Traction: force per length of the boundary; `normal` points out of the body.
struct Traction {
  BoundaryPart along;
  std::function<Point(Point x, Point normal)> force;
};

/// Traction that changes over time; only steps with contact have a time.
struct ChangingTraction {
  BoundaryPart along;
  std::function<Point(Point x, Point normal, double time)> force;
  double last_change = 0;          ///< time from which it stays the same
  std::vector<double> bends = {};  ///< times of the rows of its table
};

/// Pressure of a traction. The traction has its force on the undisplaced edge; steps add what changes as it turns.
struct FollowingPressure {
  BoundaryPart along;
  std::function<double(Point x, Point normal, double time)> pressure;
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

/// Supports a point in one direction (of length 1). As the only support of a body whose loads are in equilibrium it
/// carries no force.
struct PointSpring {
  int element = 0;
  Point at;
  Point direction;
  double stiffness = 0;  ///< force / length
};

struct Continuum {
  Manifold manifold;
  std::vector<BlockMaterial> materials;     ///< indexed by `manifold.body_materials`
  std::vector<int> element_materials = {};  ///< per element, an index into `materials`; empty: that of its body
  std::vector<ElasticLaw> laws = {};        ///< one per material; empty: St. Venant–Kirchhoff
  Plane plane = Plane::stress;
  CoverFunctions functions = CoverFunctions::derived;
  TipFunctionPlan tip_functions = {};
  std::function<Point(Point x)> body_force;  ///< force / area, added to the weight of the materials; may be empty
  std::function<Stress(Point x)>
      initial_stress;             ///< before any displacement, added to that of the materials; may be empty
  bool gives_initial_zz = false;  ///< true if `initial_stress` gives it; else the law computes stress across the plane
  std::vector<Traction> tractions;
  std::vector<ChangingTraction> changing_tractions = {};
  std::vector<FollowingPressure> pressures = {};
  std::vector<PrescribedDisplacement> prescribed;
  std::vector<PointForce> point_forces;
  std::vector<PointSpring> point_springs;
  bool faces_touch = false;            ///< crack faces press and rub in linear statics; else they pass each other
  std::vector<CrackPlan> cracks = {};  ///< of the case file: a run then reports the stress intensity of all tips

  /// Returns the index into `materials`.
  int material_number(int element) const;
  const BlockMaterial& material(int element) const;
  ElasticLaw law(int element) const;
  /// Returns D of an element, 3 × 3.
  Eigen::Matrix3d modulus(int element) const;
  /// Returns the force per area: weight and push of the element's material, and `body_force`.
  Point force_at(int element, Point x) const;
  /// Returns the initial stress of the element's material, linear in y, plus `initial_stress`.
  Stress initial_stress_at(int element, Point x) const;
};

/// Returns the functions of all elements.
CoverBasis basis_of(const Continuum& continuum);

/// Returns quadrature points of an element. They are exact to `degree` if its functions are polynomials, or else suited
/// to near-tip functions.
std::vector<AreaPoint> area_rule(const Manifold& manifold, int element, const ElementShape& shape, int degree);

/// Returns the NMM bodies of a run in steps. Weight follows `weight_per_area`; a material number out of range becomes
/// the nearest that exists.
Continuum continuum_of(Manifold manifold, const std::vector<BlockMaterial>& materials, const Settings& settings,
                       CoverFunctions functions);

/// Edge of an element on the boundary, or a part of one; the element lies to its left.
struct ElementSide {
  int element = 0;
  Segment edge;

  Point normal() const;  ///< outward, of length 1
};

/// Returns points along an edge: `count` Gauss points for polynomials. For near-tip functions the points are closer
/// near the tip and just inside the element, which decides on which face of the crack they lie.
std::vector<EdgePoint> edge_rule(const ElementSide& side, const ElementShape& shape, int count);

/// Returns the boundary edges of a manifold, each with its element.
std::vector<ElementSide> boundary_sides(const Manifold& manifold);

/// Returns the pieces of a chain.
std::vector<Segment> pieces_of(const BoundaryPart& part);

/// Returns the distance within which a chain runs along the boundary: 1e-10 of the manifold's extent.
double reach_of_chains(const Manifold& manifold);

/// Returns the boundary edges along a chain, on both sides of a joint. Edges are cut where the chain begins or ends
/// inside one; a place that the chain passes twice occurs once. Tractions and prescribed displacements along chains use
/// these edges.
std::vector<ElementSide> sides_along(const Manifold& manifold, const BoundaryPart& part);

}  // namespace keyblock
