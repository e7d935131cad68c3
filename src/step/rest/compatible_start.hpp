// Computes an initial state whose contact forces and strains fit the first accelerations, so that blocks do not
// oscillate. Theory: docs/theory/07-initial-state-and-statics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "step/scene/standard_scene.hpp"

namespace keyblock {

struct CompatibleStart {
  Motion motion;
  std::string failure;    ///< one sentence if no start was found; otherwise empty
  double misfit = 0;      ///< gaps left by the shifts, over the gaps of the first round
  int bolts = 0;          ///< bolts stretched by the loads beyond their pretension
};

/// Computes the start in four parts:
///   (a) Rigid accelerations and contact forces satisfy 0 ≤ g̈ ⊥ λn ≥ 0 with Coulomb friction.
///   (b) Strains satisfy K ε = f_ε + G_εᵀ λ − M_εr a_r.
///   (c) Blocks shift until closed gaps are 0, or −λn/p with springs.
///   (d) Tangential springs slip by the amount that their forces require.
/// Bolts that the loads would stretch at once take part in (a) to (c): they carry the rest of the load with their pull.
/// The start suits blocks that slide or topple at once, which settling in time cannot handle. In masses of wedged
/// blocks (a) has many solutions, and (c) may be impossible with small shifts: then the start fails.
CompatibleStart compatible(const StandardScene& scene, Motion motion);

}  // namespace keyblock
