// Computes the impacts of a step: removes overlaps without creating velocity, then makes the rigid velocities jump.
// Theory: docs/theory/06-impact.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "contact/solve/frictional_problem.hpp"
#include "step/bodies/integrator.hpp"
#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// Contact whose surfaces met during the step. Positions and velocities are known only at the end of the step.
struct ImpactMeeting {
  Touch touch;
  double since = 0;   ///< time from the meeting to the end of the step
  double gained = 0;  ///< approach speed gained in that time
};

/// Contacts that meet in a step, and contacts that lie against each other meanwhile, loaded or not.
struct Impacts {
  std::vector<ImpactMeeting> meetings;
  Touches touching;
  Bonds bonds;      ///< of these contacts
  double slow = 0;  ///< approach speed below which a contact is no impact
};

/// Motion after a jump.
struct Jump {
  UnknownsTable q;
  UnknownsTable v;
  double lost = 0;   ///< energy lost in contacts, ≥ 0: −Σ p·(u⁻ + u⁺)/2 (Thomson & Tait 1867)
  double given = 0;  ///< energy given by fixed points, by the same formula; 0 if impulses did not settle
  int solves = 0;    ///< linear systems factorised
  std::vector<std::size_t> undecided;  ///< meetings whose impulses did not settle
};

/// Positions after removal of overlaps.
struct Separated {
  UnknownsTable q;
  int locked = 0;  ///< overlaps kept because other blocks are in the way
  int solves = 0;  ///< linear systems factorised
};

/// Returns the flexibility for impulses. A DDA block responds with its rigid mass. The corner of a deformable block
/// moves only a fraction of the mass; a law at the corner would not give the block's restitution. An NMM body responds
/// with the inertia that a step reaches, M + θ dt² K: `step` is A⁻¹ of the step.
Flexibility impact_flexibility(const StandardScene& scene, const Flexibility& step, const StepRule& rule);

/// Moves blocks along the gap rows, with the inverse mass of an impact. Afterwards no `impact` is beyond its rest gap,
/// except those that lock each other. No `other` contact overlaps more than it did `before` the jump.
Separated without_overlap(const StandardScene& scene, UnknownsTable q, const Touches& impacts, const Touches& others,
                          const UnknownsTable& before, const Flexibility& flexibility);

/// Applies Newton's law with restitution e and Coulomb's cone to the impulses (Moreau 1988), where and when the
/// surfaces met:
///     0 ≤ p ⊥ vn⁺ − e v_approach ≥ 0,  v⁺ = v + B Gᵀ p,  q⁺ = q + B Gᵀ (since ∘ p),  B the flexibility of an impact.
/// The arms in G and the displacements since the meeting conserve angular as well as linear momentum. A law at the end
/// of the step would lose it with the overlap. Contacts that lie against each other take part without restitution. None
/// may approach faster than before, and bonded ones stay as they are. Strain rates of blocks neither jump nor count: an
/// impulse that turns strain rate into rigid velocity would create energy. With many contacts, those that approach at a
/// fraction of the slow speed are left to the next step.
Jump after_jump(const StandardScene& scene, const UnknownsTable& q, const UnknownsTable& v, const Impacts& impacts,
                const Flexibility& flexibility);

/// Moves fixed points to their targets at `time`. Otherwise impulses that did not settle leave offsets, which the next
/// step would remove by an arbitrary force.
UnknownsTable with_points_in_place(const StandardScene& scene, UnknownsTable q, double time,
                                   const Flexibility& flexibility);

/// Returns velocities without the strain rates of blocks.
UnknownsTable rigid_part(UnknownsTable v);

/// Behaviour of a contact in the clean-up. Its normal velocity stops, and it slides freely, slides with friction, or
/// sticks, or Coulomb's law governs the impulse of the whole step. Or it passes on impulses and only stops closing.
struct HeldSlip {
  double friction = 0;  ///< over the normal force
  bool sticks = false;
  std::optional<ForceLaw> of_sum = std::nullopt;    ///< law of force and impulse together, as a force
  Eigen::Vector2d force = Eigen::Vector2d::Zero();  ///< force of the contact in the step, used with `of_sum`
  /// Tangent of the angle of friction of a contact that may open, and must not close faster than before.
  std::optional<double> passes_on = std::nullopt;
  bool has_law_of_impulse() const { return of_sum || passes_on; }
};

/// Response to a push: by the inertia that a step reaches, M + θ dt² K, or by the mass alone.
struct PushAnswer {
  const Flexibility& flexibility;
  double per_force = 1;  ///< push over a force of the step
};

/// Velocities after pushes.
struct PushedVelocities {
  UnknownsTable v;
  /// Energy given by held points, (v⁻ + v⁺)ᵀ M Δv/2 of the change Δv by their pushes. A push itself also strains a body
  /// that reaches more inertia than its mass, and its work is no energy of the body.
  double given = 0;
};

/// Sets the normal velocity of closed contacts to zero and that of fixed points to the target. Both are kept in
/// position; otherwise their rates would change sign in each step. A contact opens if its law lets it. The response is
/// that of the inertia that a step reaches. Round-off of gaps thus does not excite strains too stiff for the step. If a
/// contact slides with friction, so does the impulse: the part of the normal force that impulses carry has friction.
PushedVelocities with_held_velocities(const StandardScene& scene, const UnknownsTable& q, UnknownsTable v,
                                      const Touches& closed, const std::vector<HeldSlip>& slips, double time, double dt,
                                      const PushAnswer& answered);

}  // namespace keyblock
