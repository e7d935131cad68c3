// Decides which crack tips propagate, in which direction, how far, and at which line they end.
// Theory: docs/theory/10-fracture.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "fracture/kink.hpp"
#include "fracture/tip_integrals.hpp"
#include "problem/cover_plan.hpp"
#include "result/frame.hpp"

namespace keyblock {

/// Returns the tips of a manifold as ends of cracks; a joint that ends inside is appended as a crack of its own.
std::vector<TipState> followed_tips(const Manifold& manifold, const std::vector<CrackPlan>& cracks);

/// Returns the tip of the manifold at the place of a followed tip.
const CrackTip& tip_of(const Manifold& manifold, const TipState& state);

/// Sets stress intensity factors, J, the kink angle and K_eq of the criterion; `has_room` is false if no domain has
/// room. If the rock has a mode II toughness, K_eq = K_Ic √((K_I/K_Ic)² + (K_II/K_IIc)²). A closed tip has K_I = 0 in
/// K_eq.
void put_factors(TipState& state, const CoverSolution& solution, GrowthCriterion criterion);

/// Returns the tips that reach their toughness first, and those within one per cent of them, so that symmetric tips
/// propagate together. Returns none if no tip is loaded.
std::vector<std::size_t> next_to_go_on(const std::vector<TipState>& tips);

/// End of a tip's advance by `increment` in a direction of length 1. It ends on the first line in between, or on a line
/// that a quarter of the increment more would reach.
struct Advance {
  Point to;
  bool meets_line = false;  ///< it ends on a line
};
Advance advance_of(const Manifold& manifold, Point tip, Point direction, double increment);

/// Returns another tip ahead, within 45 degrees of the direction and nearer than `reach`.
std::optional<Point> facing_tip(const Manifold& manifold, Point tip, Point direction, double reach);

/// Returns the nearest point of another line within `reach` that is not behind the tip; a tip without room goes there.
std::optional<Point> line_beside(const Manifold& manifold, const CrackTip& tip, double reach);

/// Returns the speed of waves along a free surface [length / time], within half a per cent (Achenbach 1973, Wave
/// Propagation in Elastic Solids). It bounds the speed of a tip in mode I (Freund 1990, Dynamic Fracture Mechanics,
/// chapter 7).
double rayleigh_speed(const PlaneElasticity& rock, double density);

/// Returns a direction rotated to the left by an angle [rad].
Point turned_to_left(Point direction, double angle);

/// Extends the crack of a tip; at a joint that ends inside, a new crack begins.
void prolong(std::vector<CrackPlan>& cracks, const TipState& tip, Point to);

}  // namespace keyblock
