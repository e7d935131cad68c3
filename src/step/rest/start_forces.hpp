// Holds the unknowns of a compatible start: forces of contacts, stretched bolts and fixed points, and the motion that
// they must fit. Theory: docs/theory/07-initial-state-and-statics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "contact/rows/constraints.hpp"
#include "contact/solve/frictional_problem.hpp"
#include "step/scene/contact_laws.hpp"
#include "step/scene/touch_search.hpp"

namespace keyblock {

/// Forces of a compatible start. Rows and forces are ordered: contacts, bolts stretched by the loads, fixed points.
/// Rows of bolts are reversed, because a bolt pulls and a contact pushes. Keeps a reference to the scene.
struct StartForces {
  /// Least mass that counts, relative to the heaviest block. Next to the compliance of a block of 1e-6 of their mass,
  /// the interaction of two heavy blocks would be round-off. Shifts and force residuals would then be undetermined.
  static constexpr double kLightest = 1e-3;

  StartForces(const StandardScene& scene, Motion motion);

  /// Computes the rows at the current motion.
  void make_rows();
  /// Finds the forces of rigid blocks from complementarity of accelerations. Forces stay undetermined if more contacts
  /// carry than statics needs. Velocities after one step of free acceleration stand for g̈, so that a sliding block
  /// keeps its direction.
  void find();
  /// Distributes the forces among elastic blocks. Blocks loaded by f − M a strain and shift until their gaps are met
  /// (inertia relief); sliding contacts keep sliding. A mass over the square of a long time keeps rigid motion finite.
  void distribute();

  /// Adds bolts. The force across a bolt is zero; a diagonal entry of 1 keeps its row from being singular.
  void add_bolts(FrictionalProblem& problem) const;
  /// Returns the rigid inverse masses; blocks lighter than `share` of the heaviest count as that.
  Table<ElementIndex, UnknownBlock> counted_as(double share) const;

  /// Returns gaps and slips of contacts less those that their forces require. Slip counts for bonds alone: friction may
  /// have let faces expand freely.
  Eigen::VectorXd gaps_from_wanted() const;
  /// Returns true if the contact has a force or a bond.
  bool carries(std::size_t touch) const;
  /// Returns the motion along the rows since the scene was drawn.
  Eigen::VectorXd slips() const;
  /// Returns the ways of held points from where they are held.
  Eigen::VectorXd held_offsets() const;
  /// Returns the sum of the gaps and of the ways of held points to be closed.
  double missing() const;
  /// Returns true if forces distributed by elasticity still give the accelerations.
  bool balances() const;

  ContactLaw law(std::size_t touch) const;
  static Eigen::Index tangential(std::size_t touch) { return static_cast<Eigen::Index>(2 * touch + 1); }
  double normal(std::size_t touch) const { return forces[static_cast<Eigen::Index>(2 * touch)]; }
  Eigen::Index bolt_row(std::size_t i) const { return static_cast<Eigen::Index>(2 * (touches.size() + i)); }
  const Bolt& bolt(std::size_t i) const { return scene.model.bolts[bolts[i]]; }
  double tension(std::size_t i) const { return forces[bolt_row(i)]; }  ///< beyond the pretension
  double elongation(std::size_t i) const {
    return elongations(scene.model, scene.reference, motion.q)[static_cast<Eigen::Index>(bolts[i])];
  }
  int carrying_bolts() const;

  /// Returns B x of each block.
  static UnknownsTable product(const Table<ElementIndex, UnknownBlock>& blocks, const UnknownsTable& x);
  Table<ElementIndex, UnknownBlock> identities() const;

  const StandardScene& scene;
  Motion motion;
  UnknownsTable drawn;  ///< q before any strain or shift: bonds keep the points that met there
  UnknownsTable loads;  ///< with pretensions and centrifugal terms
  Table<ElementIndex, UnknownBlock> rigid;
  Touches touches;
  std::vector<std::size_t> bolts;    ///< stretched by the loads
  double acceleration_of_loads = 0;  ///< greatest, without pretensions
  Scales scales;
  double tolerance = 0;
  double acceptable = 0;  ///< used if `tolerance` is out of reach
  double heaviest = 0;
  ContactRows rows;
  Eigen::VectorXd forces;
  Eigen::VectorXd elastic;  ///< forces of the last round that elasticity distributed
  UnknownsTable acceleration;
};

}  // namespace keyblock
