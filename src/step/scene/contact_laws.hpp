// The law of each touch: what its joint material, its bond and its enforcement make of its forces.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/solve/frictional_problem.hpp"
#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// A touch as a force: its law, what it adds to gap and slip a unit of force, and where its gap is counted from.
struct ContactLaw {
  ForceLaw force;
  double normal_compliance = 0;      ///< 1/p of a spring, 0 of a multiplier, length / force
  double tangential_compliance = 0;  ///< 1/p_t
  double normal_weight = 0;          ///< 1/p of the proximal term of an augmented Lagrangian
  double tangential_weight = 0;
  double rest_gap = 0;        ///< of the touch; of a bond: what was between its faces when it was made
  double shear_strength = 0;  ///< of a bond: cohesion times its length
  bool is_bonded = false;
};

/// Compliance of the springs that the contact stiffness gives a touch, length / force.
struct Springs {
  double normal = 0;
  double tangential = 0;
};
Springs springs_of(const StandardScene& scene, const Touch& touch);

/// The touches whose joint materials make no springs of them.
Touches without_springs(const StandardScene& scene, Touches touches);

/// What a touch with this law remembers of its forces: its springs are as long as they ask for.
ContactMemory memory_of(const ContactLaw& law, double normal, double tangential);

/// The same after a step in which its point slipped by `slip`, `before` it or nothing. A spring that sticks is longer
/// by all of that: its force in the step is that of the velocity at the end, whose sum over the steps is another way
/// wherever velocities are changed between steps, and would wind springs up.
ContactMemory memory_of(const ContactLaw& law, double normal, double tangential, double slip,
                        const ContactMemory* before);

/// Whether a tangential force is below what friction or a bond holds, by more than round-off.
bool sticks(const ContactLaw& law, double normal, double tangential);

/// λn ≥ −T l and no slip for bonded touches, with l the length that the touch stands for; Coulomb for the others. The
/// shear of bonds is judged by `sheared_bonds`. A spring stands for the share of its stretch: both ends of a stretch
/// have the contact stiffness p each, three points 2p by Lobatto's weights.
ContactLaw contact_law(const StandardScene& scene, const Bonds& bonds, const Touch& touch);

/// The bonds between edges whose shear is beyond Mohr and Coulomb's limit by more than `tolerance`,
///     |Σ λt| > Σ (c l + λn tan φ),
/// summed over the bonds of a pair of edges: how two elastic blocks share a force among the points of one face is no
/// matter of the strength of that face (limit equilibrium of a joint, Hoek & Bray 1981).
std::vector<Facing> sheared_bonds(const Touches& touches, const std::vector<ContactLaw>& laws,
                                  const Eigen::VectorXd& forces, double tolerance);

/// Whether a body of a touch resolves by itself how an impact goes on: bodies on covers do.
bool resolves_impact(const StandardScene& scene, const Touch& touch);

/// Bonds of resting touches whose joint material has strength.
Bonds bonds_at(const StandardScene& scene, const UnknownsTable& q, const Touches& resting);

}  // namespace keyblock
