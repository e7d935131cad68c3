// The parts of a cover plan as the continuum takes them: formulas become functions of the place.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/error.hpp"
#include "model/continuum.hpp"
#include "problem/blocks.hpp"
#include "problem/cover_plan.hpp"

namespace keyblock {

/// Everything of the plan that does not depend on the mesh. Functions throw InputError where a formula has no finite
/// value.
void put_loads(Continuum& continuum, const CoverPlan& plan);

/// A plan without what has nothing to act on: chains of which the bodies have no edge, points that lie in no body.
CoverPlan what_is_left_of(CoverPlan plan, const Manifold& bodies, const Blocks& blocks);

/// Forces and springs at points, into their elements. Throws InputError for one that lies in no body.
void put_points(Continuum& continuum, const CoverPlan& plan);

/// What is to be said of the chains of a plan, and of its loads: `scenes` are the bodies of a run, one after another.
/// Throws InputError for a chain that is on the boundary of none of them, where a formula has no finite value, and
/// where two prescribed displacements contradict each other.
Warnings look_at_plan(const CoverPlan& plan, const std::vector<const Continuum*>& scenes);

/// The element that holds the point, of `body` if that is not -1. Throws InputError, saying `noun`, where none does.
int element_holding(const Manifold& manifold, int body, Point p, const char* noun, const Place& place);

}  // namespace keyblock
