// The law of each touch: what its joint material, its bond and its enforcement make of its forces.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/frictional_problem.hpp"
#include "step/standard_scene.hpp"

namespace keyblock {

/// A touch as a force: its law, what it adds to gap and slip a unit of force, and where its gap is counted from.
struct ContactLaw {
  ForceLaw force;
  double normal_compliance = 0;      ///< 1/p of a spring, 0 of a multiplier, length / force
  double tangential_compliance = 0;  ///< 1/p_t
  double normal_weight = 0;          ///< 1/p of the proximal term of an augmented Lagrangian
  double tangential_weight = 0;
  double rest_gap = 0;  ///< of the touch; of a bond: what was between its faces when it was made
  bool is_bonded = false;
};

/// The touches whose joint materials make no springs of them.
Touches without_springs(const StandardScene& scene, Touches touches);

/// What a touch with this law remembers of its forces.
ContactMemory memory_of(const ContactLaw& law, double normal, double tangential);

/// Mohr-Coulomb with tension cut-off for bonded touches, |λt| ≤ c l + λn tan φ and λn ≥ −T l with l the length that the touch
/// stands for; Coulomb for the others. A spring stands for the share of its stretch: both ends of a stretch have the contact
/// stiffness p each, three points 2p by Lobatto's weights (contact-notes 6).
ContactLaw contact_law(const StandardScene& scene, const Bonds& bonds, const Touch& touch);

/// Bonds of resting touches whose joint material has strength.
Bonds bonds_at(const StandardScene& scene, const UnknownsTable& q, const Touches& resting);

}  // namespace keyblock
