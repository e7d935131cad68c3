// Cracks that grow, as a step left them, and how they go on: at rest and in time.
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
  std::vector<TipState> tips;      ///< those that go on are marked
  std::vector<CrackStart> starts;  ///< cracks that start next in intact rock
};

/// The tips of these cracks with their factors.
std::vector<TipState> tips_of(const CoverSolution& solution, const std::vector<CrackPlan>& cracks,
                              GrowthCriterion criterion);

/// Where a tip without room goes, straight ahead or to what lies beside it: to the line that is in its way; none where
/// that is farther than an increment.
std::optional<Point> way_through(const Manifold& manifold, const CrackTip& tip, double increment);

/// The cracks when they have gone on by an increment, and those that started have their length. Tip i goes by its kink
/// and more[i] (rad, to the left); two that go on towards each other meet half way. The manifold is that of the front.
std::vector<CrackPlan> prolonged(const CrackFront& front, const Manifold& manifold, double increment,
                                 const std::vector<double>& more);

/// Half of the kink (rad) that a trial of a step finds at each tip of the front that went on by its own kink; 0 of the
/// others.
std::vector<double> kink_corrections(const CrackFront& front, const std::vector<TipState>& found);

/// Notes what the front of a step shows: tips that go on though their faces overlap, cracks that start where the mesh
/// is coarse for them.
void note_front(CrackNotes& notes, int step, const CrackFront& front);

/// Notes the tips of a front at rest that went on from the front before: K_II is 0 behind an increment that is short
/// for how the path bends (local symmetry, Goldstein & Salganik 1974).
void note_bends(CrackNotes& notes, int step, const CrackFront& before, const CrackFront& now);

/// "tip 2 (crack 1) at (3, 4)".
std::string words_of(const TipState& tip, std::size_t number);

void describe(Archive& archive, const char* name, std::vector<CrackPlan>& cracks);
/// `cracks_shown`, `tips` and `starts`.
void describe(Archive& archive, CrackFront& front);

}  // namespace keyblock
