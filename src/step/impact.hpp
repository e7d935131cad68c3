// Impacts of a step: overlaps removed without making velocity, then a jump of the rigid velocities.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/standard_scene.hpp"

namespace keyblock {

/// A touch that takes part in a jump; `approach` is its speed at the surface, 0 for one that was closed before.
struct Party {
  Touch touch;
  double approach = 0;
};

/// Moves blocks along the gap rows with the rigid inverse mass until no `impact` overlaps and no `closed` touch is
/// deeper than it was.
UnknownsTable without_overlap(const StandardScene& scene, UnknownsTable q, const Touches& impacts,
                              const Touches& closed);

/// Newton's law with restitution e and Coulomb's cone on the impulses (Moreau 1988):
///     0 ≤ p ⊥ vn⁺ − e v_approach ≥ 0,  v⁺ = v + M_rigid⁻¹ Gᵀ p.
/// Strain rates do not jump: the corner of a deformable block sees a fraction of its mass, and the law at the corner
/// would not give the body's restitution (contact-notes 4.4).
UnknownsTable after_jump(const StandardScene& scene, const UnknownsTable& q, const UnknownsTable& v,
                         const std::vector<Party>& parties);

/// Makes the normal velocity of closed touches zero and that of held points what their motion wants, with the full mass: both
/// are kept in positions, and without this their rates would change sign each step (contact-notes 3, step 8).
UnknownsTable with_held_velocities(const StandardScene& scene, const UnknownsTable& q, UnknownsTable v,
                                   const Touches& closed, double time, double dt);

}  // namespace keyblock
