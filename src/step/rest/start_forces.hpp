// What a compatible start is sought with: touches, stretched bolts and held points with their forces, and the motion
// that these are to fit.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "contact/rows/constraints.hpp"
#include "contact/solve/frictional_problem.hpp"
#include "step/scene/contact_laws.hpp"
#include "step/scene/touch_search.hpp"

namespace keyblock {

/// Rows and forces come in this order: touches, the bolts that the loads stretch, held points. A bolt pulls as a touch
/// pushes: its rows are turned over. Views the scene.
struct StartForces {
  /// Of the heaviest block. Beside what a block of a millionth of their mass yields, what two heavy blocks do to each
  /// other is round-off: which of two a shift moves is open, and by which of them a force is judged.
  static constexpr double kLightest = 1e-3;

  StartForces(const StandardScene& scene, Motion motion);

  /// Rows as the motion lies.
  void make_rows();
  /// Of rigid blocks: by complementarity of accelerations, which leaves forces open where more touches carry than
  /// statics needs. Velocities after one step of free acceleration stand for g̈, so that a block that slides already
  /// keeps its direction.
  void find();
  /// Of elastic blocks: the ones under which blocks loaded by f − M a strain and shift until the gaps are met (inertia
  /// relief), sliding touches sliding on. Rigid motion is kept finite by a mass over a long time squared.
  void distribute();

  /// Across a bolt there is no force; the one keeps its row from being singular.
  void add_bolts(FrictionalProblem& problem) const;
  /// Of the rigid masses, light ones counted as a share of the heaviest.
  Table<ElementIndex, UnknownBlock> counted_as(double share) const;

  /// Gaps of touches, counted from those that the forces want.
  std::vector<double> gaps_from_wanted() const;
  /// Sum of the gaps that are to be closed.
  double missing() const;
  /// Whether forces that elasticity distributed still give the accelerations, where bolts are among them: contacts have
  /// their gaps for that.
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

  /// B x of each block.
  static UnknownsTable product(const Table<ElementIndex, UnknownBlock>& blocks, const UnknownsTable& x);
  Table<ElementIndex, UnknownBlock> identities() const;

  const StandardScene& scene;
  Motion motion;
  UnknownsTable loads;  ///< with pretensions, and of spin
  Table<ElementIndex, UnknownBlock> rigid;
  Touches touches;
  std::vector<std::size_t> bolts;    ///< stretched by the loads
  double acceleration_of_loads = 0;  ///< greatest, without pretensions
  Scales scales;
  double tolerance = 0;
  double acceptable = 0;  ///< where that is out of reach
  double heaviest = 0;
  ContactRows rows;
  Eigen::VectorXd forces;
  Eigen::VectorXd elastic;  ///< forces of the last round that elasticity distributed
  UnknownsTable acceleration;
};

}  // namespace keyblock
