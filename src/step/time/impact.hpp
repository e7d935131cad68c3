// Impacts of a step: overlaps removed without making velocity, then a jump of the rigid velocities.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "step/bodies/integrator.hpp"
#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// A touch whose surfaces met during the step, before its end at which positions and velocities are known.
struct ImpactMeeting {
  Touch touch;
  double since = 0;   ///< time from the meeting to the end of the step
  double gained = 0;  ///< approach speed that was gained in that time
};

/// Touches that meet in a step, and those that lie against each other meanwhile, whether they bear or not.
struct Impacts {
  std::vector<ImpactMeeting> meetings;
  Touches touching;
  Bonds bonds;      ///< of these touches
  double slow = 0;  ///< approach speed below which a contact is no impact
};

/// A motion after a jump.
struct Jump {
  UnknownsTable q;
  UnknownsTable v;
  double lost = 0;  ///< energy that contacts took, ≥ 0: −Σ p·(u⁻ + u⁺)/2 of their impulses (Thomson & Tait 1867)
  double given = 0;                    ///< that held points gave, likewise; 0 of impulses left open
  int solves = 0;                      ///< linear systems factorised
  std::vector<std::size_t> undecided;  ///< meetings whose impulses would not settle
};

/// Positions after overlaps were pushed out.
struct Separated {
  UnknownsTable q;
  int locked = 0;  ///< overlaps left as they were, because others are in the way
  int solves = 0;  ///< linear systems factorised
};

/// Velocities that an impulse makes. A block answers with its rigid mass: the corner of a deformable block sees a
/// fraction of the mass, and the law at the corner would not give the block's restitution. A body on covers answers
/// with what the instant can reach, the inertia of a step of it, M + θ dt² K: `step` is A⁻¹ of the step.
Flexibility impact_flexibility(const StandardScene& scene, const Flexibility& step, const StepRule& rule);

/// Moves blocks along the gap rows with the inverse mass of an impact until no `impact` is beyond its rest gap, but for
/// those that lock each other, and no `other` touch overlaps more than it did `before` the jump.
Separated without_overlap(const StandardScene& scene, UnknownsTable q, const Touches& impacts, const Touches& others,
                          const UnknownsTable& before, const Flexibility& flexibility);

/// Newton's law with restitution e and Coulomb's cone on the impulses (Moreau 1988), where and when the surfaces met:
///     0 ≤ p ⊥ vn⁺ − e v_approach ≥ 0,  v⁺ = v + B Gᵀ p,  q⁺ = q + B Gᵀ (since ∘ p),  B the flexibility of an impact.
/// With the arms in G and the way since the meeting angular momentum is kept as linear is; a law at the end of the step
/// loses it with the overlap. Touches that lie against each other take part without restitution; none approaches faster
/// than before, and bonded ones go on as they do. Strain rates of blocks do not jump, nor are they seen: an impulse
/// that makes rigid velocity of a strain rate creates energy. Among many touches those that approach at a share of the
/// slow speed are left to the next step.
Jump after_jump(const StandardScene& scene, const UnknownsTable& q, const UnknownsTable& v, const Impacts& impacts,
                const Flexibility& flexibility);

/// Puts held points where their motion wants them at `time`: what impulses that did not settle leave of their offsets
/// would be pulled back in the next step by any force.
UnknownsTable with_points_in_place(const StandardScene& scene, UnknownsTable q, double time,
                                   const Flexibility& flexibility);

/// Velocities without the strain rates of blocks.
UnknownsTable rigid_part(UnknownsTable v);

/// What a touch whose normal velocity is held does along its edge: it slides freely, with friction, or sticks; or
/// Coulomb's law says it of the impulse of the whole step.
struct HeldSlip {
  double friction = 0;  ///< over the normal force
  bool sticks = false;
  std::optional<double> coulomb = std::nullopt;     ///< tangent of the angle of friction
  Eigen::Vector2d force = Eigen::Vector2d::Zero();  ///< coulomb: that the touch had in the step
};

/// What answers a push: the inertia that a step reaches, M + θ dt² K, or the mass alone.
struct PushAnswer {
  const Flexibility& flexibility;
  double per_force = 1;  ///< push over a force of the step
  double mass = 1;       ///< push over impulse: the flexibility of a rigid body is M⁻¹ over this
};

/// Velocities that pushes made.
struct PushedVelocities {
  UnknownsTable v;
  double given = 0;  ///< energy that held points gave, Σ p·(u⁻ + u⁺)/2: a driven support moves with its point
};

/// Makes the normal velocity of closed touches zero and that of held points what their motion wants: both are kept in
/// positions, and without this their rates would change sign each step. What answers is the inertia that a step
/// reaches, so that strains too stiff for the step are not struck by round-off of gaps. Where a contact slides with
/// friction, so does the impulse: else what the impulses bear of the normal force would be without.
PushedVelocities with_held_velocities(const StandardScene& scene, const UnknownsTable& q, UnknownsTable v,
                                      const Touches& closed, const std::vector<HeldSlip>& slips, double time, double dt,
                                      const PushAnswer& answered);

}  // namespace keyblock
