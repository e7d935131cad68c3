// Converts the parts of a cover plan for the continuum: formulas become functions of the position.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "base/error.hpp"
#include "model/continuum.hpp"
#include "problem/blocks.hpp"
#include "problem/cover_plan.hpp"
#include "problem/time_curve.hpp"

namespace keyblock {

/// Traction along a chain as functions of the position, the outward normal and the time.
struct TractionOnEdge {
  std::function<Point(Point x, Point normal, double time)> force;  ///< of a fixed direction
  std::function<double(Point x, Point normal, double time)> pressure;
};

/// Returns the factors as the first components of a curve.
TimeCurve curve_of(const std::vector<FactorAt>& rows);

/// The functions throw InputError if a formula is not finite.
TractionOnEdge traction_on_edge(const TractionPlan& plan);
PrescribedDisplacement displacement_of(const DisplacementPlan& plan);

/// Adds all parts of the plan that do not depend on the mesh. The functions throw InputError if a formula is not
/// finite.
void put_loads(Continuum& continuum, const CoverPlan& plan);

/// Returns the plan without parts that have nothing to act on: chains off all edges of the bodies, points in no body.
CoverPlan what_is_left_of(CoverPlan plan, const Manifold& bodies, const Blocks& blocks);

/// Adds point forces and springs to their elements. Throws InputError for one that lies in no body.
void put_points(Continuum& continuum, const CoverPlan& plan);

/// Returns the element that holds the point; of `body`, unless that is -1. Throws InputError that names `noun` if no
/// element does.
int element_holding(const Manifold& manifold, int body, Point p, const char* noun, const Place& place);

}  // namespace keyblock
