// A start in which contact forces and strains fit the first accelerations, so that nothing rings.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/standard_scene.hpp"

namespace keyblock {

/// (a) rigid accelerations and contact forces from 0 ≤ g̈ ⊥ λn ≥ 0 with Coulomb friction; (b) strains from
/// K ε = f_ε + G_εᵀ λ − M_εr a_r; (c) blocks shifted until closed gaps are 0, or −λn/p with springs; (d) the slip of the
/// springs. It serves blocks that will slide or topple at once, which settling in time cannot (contact-notes 5).
Motion compatible(const StandardScene& scene, Motion motion);

}  // namespace keyblock
