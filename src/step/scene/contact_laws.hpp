// Defines the force law of each contact from its joint material, bond and enforcement. Theory:
// docs/theory/05-frictional-contact.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/solve/frictional_problem.hpp"
#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// Force law of a contact, the changes of gap and slip per unit force, and the origin of the gap.
struct ContactLaw {
  ForceLaw force;
  double normal_compliance = 0;      ///< 1/p of a spring, 0 of a multiplier, length / force
  double tangential_compliance = 0;  ///< 1/p_t
  double normal_weight = 0;          ///< 1/p of the proximal term of an augmented Lagrangian
  double tangential_weight = 0;
  double rest_gap = 0;        ///< of the contact; for a bond, the gap of its faces when it was made
  double shear_strength = 0;  ///< of a bond: cohesion times its length
  double bonded_length = 0;
  bool is_bonded = false;
};

/// Compliance of a contact's springs by the contact stiffness [length / force].
struct Springs {
  double normal = 0;
  double tangential = 0;
};
Springs springs_of(const StandardScene& scene, const Touch& touch);

/// Returns the contacts whose joint materials use no springs.
Touches without_springs(const StandardScene& scene, Touches touches);

/// Returns the memory of a contact with this law: its springs have the lengths of the forces.
ContactMemory memory_of(const ContactLaw& law, double normal, double tangential);

/// Returns the same after a step in which its point slipped by `slip`; `before`: earlier memory or null. The spring of
/// a sticking contact becomes longer by the slip, up to twice the stretch at the limit of friction; the rest is
/// plastic. Its force in the step follows from the end velocity. The sum of such forces differs from the path if
/// velocities change between steps, and would wind the springs up.
ContactMemory memory_of(const ContactLaw& law, double normal, double tangential, double slip,
                        const ContactMemory* before);

/// Returns true if a tangential force is below the limit of friction or bond by more than round-off.
bool sticks(const ContactLaw& law, double normal, double tangential);

/// Returns the law of a contact. Bonded contacts have λn ≥ −T l and no slip, l the length of the contact; others follow
/// Coulomb. `overloaded_faces` judges shear and bending of bonds. A spring acts for its share of a stretch. Both ends
/// of a stretch have the contact stiffness p each, three points 2p by Lobatto's weights.
ContactLaw contact_law(const StandardScene& scene, const Bonds& bonds, const Touch& touch);

/// Returns the bonds between edges whose shear exceeds the Mohr–Coulomb limit by more than `tolerance`:
///     |Σ λt| > Σ (c l + λn tan φ),
/// summed over the bonds of a pair of edges. The strength of a face is independent of the distribution of a force among
/// its points (limit equilibrium of a joint, Hoek & Bray 1981). On faces of DDA blocks it also returns those that tear
/// under a force N and a moment M about their middle:
///     |M| > N L/2  and  6 |M| / L − N > T L,
/// L the length of the face. That is the stress of a beam at the edge of the face (Navier 1826). If the force meets the
/// face, an open part of it does no harm. The mesh of NMM bodies has that stress itself.
std::vector<Facing> overloaded_faces(const StandardScene& scene, const UnknownsTable& q, const Touches& touches,
                                     const std::vector<ContactLaw>& laws, const Eigen::VectorXd& forces,
                                     double tolerance);

/// Returns true if a body of the contact resolves impacts by itself, as NMM bodies do.
bool resolves_impact(const StandardScene& scene, const Touch& touch);

/// Returns true if two faces can be bonded there: they face each other, and their joint material has strength.
bool has_strength(const StandardScene& scene, const Touch& touch);

/// Returns the bonds of such faces that rest within kDrawnTogether of block size of each other.
Bonds bonds_at(const StandardScene& scene, const Motion& motion, const Scales& scales);

}  // namespace keyblock
