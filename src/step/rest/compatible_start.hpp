// A start in which contact forces and strains fit the first accelerations, so that nothing rings.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "step/scene/standard_scene.hpp"

namespace keyblock {

struct CompatibleStart {
  Motion motion;
  std::string failure;    ///< one sentence, if there is none; empty otherwise
  double misfit = 0;      ///< what is left of the gaps that shifts were to close, over those of the first round
  int bolts = 0;          ///< that the loads stretch beyond their pretension
  bool balances = false;  ///< whether no bolt is to break at once, and forces and accelerations fit
};

/// (a) rigid accelerations and contact forces from 0 ≤ g̈ ⊥ λn ≥ 0 with Coulomb friction; (b) strains from
/// K ε = f_ε + G_εᵀ λ − M_εr a_r; (c) blocks shifted until closed gaps are 0, or −λn/p with springs; (d) the slip of
/// the springs. Bolts that the loads would stretch at once take part in all three: they pull what contacts and
/// pretension do not bear. It serves blocks that will slide or topple at once, which settling in time cannot.
/// In masses of wedged blocks (a) is one answer of many and (c) may not be possible with small shifts: then it fails.
CompatibleStart compatible(const StandardScene& scene, Motion motion);

}  // namespace keyblock
