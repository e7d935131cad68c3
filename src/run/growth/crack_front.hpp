// Holds growing cracks after a step and computes their extension, in statics and dynamics. Theory:
// docs/theory/10-fracture.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "fracture/growth.hpp"
#include "fracture/initiation.hpp"
#include "problem/cover_plan.hpp"
#include "result/crack_notes.hpp"

namespace keyblock {

struct CrackFront {
  std::vector<CrackPlan> cracks;
  std::vector<TipState> tips;      ///< extending ones are marked
  std::vector<CrackStart> starts;  ///< cracks that start next in intact rock
};

/// Returns the tips of these cracks with their stress intensity factors.
std::vector<TipState> tips_of(const CoverSolution& solution, const std::vector<CrackPlan>& cracks,
                              GrowthCriterion criterion);

/// Returns the end point for a tip without room: straight ahead, or to the line beside it that is in its way. Empty if
/// that is farther than an increment.
std::optional<Point> way_through(const Manifold& manifold, const CrackTip& tip, double increment);

/// Returns the cracks extended by an increment; cracks that started have their length. Tip i extends by its kink plus
/// more[i] (rad, to the left). Two tips that extend towards each other meet half way. `manifold`: that of the front.
std::vector<CrackPlan> prolonged(const CrackFront& front, const Manifold& manifold, double increment,
                                 const std::vector<double>& more);

/// Returns half of the kink (rad) that a trial of a step finds at each tip that extended by its own kink; 0 for the
/// others.
std::vector<double> kink_corrections(const CrackFront& front, const std::vector<TipState>& found);

/// Notes tips of a step that extend although their faces overlap, and cracks that start where the mesh is coarse.
void note_front(CrackNotes& notes, int step, const CrackFront& front);

/// Notes the tips of a static front that extended from the last one. K_II is 0 behind an increment short relative to
/// the curvature of the path (local symmetry, Goldstein & Salganik 1974).
void note_bends(CrackNotes& notes, int step, const CrackFront& before, const CrackFront& now);

/// Returns "tip 2 (crack 1) at (3, 4)".
std::string words_of(const TipState& tip, std::size_t number);

void describe(Archive& archive, const char* name, std::vector<CrackPlan>& cracks);
/// Saves or restores `cracks_shown`, `tips` and `starts`.
void describe(Archive& archive, CrackFront& front);

}  // namespace keyblock
