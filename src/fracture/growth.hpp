// How tips go on: which of them, in which direction, how far, and what they end on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "fracture/kink.hpp"
#include "fracture/tip_integrals.hpp"
#include "problem/cover_plan.hpp"
#include "result/frame.hpp"

namespace keyblock {

/// The tips of a manifold as ends of cracks; a joint that ends inside is a crack behind those of the list.
std::vector<TipState> followed_tips(const Manifold& manifold, const std::vector<CrackPlan>& cracks);

/// The tip of the manifold at the place of a followed one.
const CrackTip& tip_of(const Manifold& manifold, const TipState& state);

/// Puts factors, J, the kink and K_eq of the criterion; `has_room` where a domain had none. Where the rock has a
/// toughness of mode II, K_eq = K_Ic √((K_I/K_Ic)² + (K_II/K_IIc)²). A closed tip has K_I = 0 in K_eq.
void put_factors(TipState& state, const CoverSolution& solution, GrowthCriterion criterion);

/// Those that reach their toughness first, and those within one per cent of them: symmetric tips go on together, and no
/// number decides. None where nothing pulls at any.
std::vector<std::size_t> next_to_go_on(const std::vector<TipState>& tips);

/// Where a tip comes to that goes on by `increment` in a direction of length 1: on the first line that is in the way,
/// or that a quarter of the increment more would reach.
struct Advance {
  Point to;
  bool meets_line = false;  ///< it ends there
};
Advance advance_of(const Manifold& manifold, Point tip, Point direction, double increment);

/// Another tip ahead, within 45 degrees of the direction and nearer than `reach`.
std::optional<Point> facing_tip(const Manifold& manifold, Point tip, Point direction, double reach);

/// The nearest point of another line that is not behind the tip, within `reach`: where a tip without room goes.
std::optional<Point> line_beside(const Manifold& manifold, const CrackTip& tip, double reach);

/// Of waves along a free surface, length / time, within half a per cent (Achenbach 1973, Wave Propagation in Elastic
/// Solids): what a tip in mode I nears and never passes (Freund 1990, Dynamic Fracture Mechanics, chapter 7).
double rayleigh_speed(const PlaneElasticity& rock, double density);

/// A direction turned to the left by an angle (rad).
Point turned_to_left(Point direction, double angle);

/// Prolongs the crack of a tip; of a joint that ends inside a crack begins there.
void prolong(std::vector<CrackPlan>& cracks, const TipState& tip, Point to);

}  // namespace keyblock
