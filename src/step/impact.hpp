// Impacts of a step: overlaps removed without making velocity, then a jump of the rigid velocities.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/standard_scene.hpp"

namespace keyblock {

/// A touch whose surfaces met during the step, before its end at which positions and velocities are known.
struct Meeting {
  Touch touch;
  double since = 0;   ///< time from the meeting to the end of the step
  double gained = 0;  ///< approach speed that was gained in that time
};

/// A motion after a jump.
struct Jump {
  UnknownsTable q;
  UnknownsTable v;
};

/// Positions after overlaps were pushed out.
struct Separated {
  UnknownsTable q;
  int locked = 0;  ///< overlaps left as they were, because others are in the way
  int solves = 0;  ///< linear systems factorised
};

/// Moves blocks along the gap rows with the rigid inverse mass until no `impact` is beyond its rest gap, but for those that lock
/// each other, and no `closed` touch deeper than it was.
Separated without_overlap(const StandardScene& scene, UnknownsTable q, const Touches& impacts, const Touches& closed);

/// Newton's law with restitution e and Coulomb's cone on the impulses (Moreau 1988), where and when the surfaces met:
///     0 ≤ p ⊥ vn⁺ − e v_approach ≥ 0,  v⁺ = v + M_rigid⁻¹ Gᵀ p,  q⁺ = q + M_rigid⁻¹ Gᵀ (since ∘ p).
/// With the arms in G and the way since the meeting angular momentum is kept as linear is; a law at the end of the step loses
/// it with the overlap. Closed touches take part without restitution; none approaches faster than before.
/// Strain rates do not jump: the corner of a deformable block sees a fraction of its mass, and the law at the corner
/// would not give the body's restitution. Nor are they seen: all velocities here are rigid ones, for an
/// impulse that makes rigid velocity of a strain rate creates energy.
Jump after_jump(const StandardScene& scene, const UnknownsTable& q, const UnknownsTable& v,
                const std::vector<Meeting>& meetings, const Touches& closed);

/// Velocities without their strain rates, in the configuration q.
UnknownsTable rigid_part(const StandardScene& scene, const UnknownsTable& q, UnknownsTable v);

/// Makes the normal velocity of closed touches zero and that of held points what their motion wants: both are kept in positions, and
/// without this their rates would change sign each step. `flexibility` is that of the step, A⁻¹: what answers is the inertia that a step
/// reaches, M + θ dt² K up to a factor, so that strains too stiff for the step are not struck by round-off of gaps.
UnknownsTable with_held_velocities(const StandardScene& scene, const UnknownsTable& q, UnknownsTable v,
                                   const Touches& closed, double time, double dt, const Flexibility& flexibility);

}  // namespace keyblock
