// Keeps impulses with rebound, and pushes of the clean-up, from making energy. Theory: docs/theory/06-impact.md, 6.3,
// 6.5.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "contact/solve/frictional_problem.hpp"
#include "step/scene/standard_scene.hpp"
#include "step/time/smooth_motion.hpp"

namespace keyblock {

/// Contacts of a jump, followed by the fixed points, with two rows each.
struct JumpRows {
  const StandardScene& scene;
  const Touches& touches;
  const ContactRows& rows;
  const Eigen::VectorXd& before;  ///< rates of the rows before the jump
  const Flexibility& flexibility;
};

/// Newton's law of restitution can make energy where contacts with friction are hit together (Stronge 1990). This moves
/// the impulses of each connected set of bodies that gains energy towards `stopped()`, those without rebound, until it
/// gains none:
///     p = p0 + α (p1 − p0),  α the largest in [0, 1] with −Σ p·(u⁻ + u⁺)/2 ≥ 0 over its contacts.
/// Coulomb's cone holds for p as it does for p0 and p1.
void take_gain(const JumpRows& of, const std::function<FrictionalSolution()>& stopped, FrictionalSolution& bouncing);

/// Sets of elements that the closed contacts of a step connect. Elements that cannot move connect nothing.
class PushedSets {
 public:
  explicit PushedSets(const ClosingStep& of);

  /// Returns true if a bond holds two blocks of the contact's set together, or may pull.
  bool has_bond(std::size_t contact) const { return has_bond_[set_of(contact)]; }

  /// Friction permits several impulses, and a wedge may be thrown by some. This shrinks the pushes of each set that
  /// gains more kinetic energy than its `pushed` contacts took in the smooth motion, until it gains no more. `before`:
  /// velocities without pushes. Returns the smallest fraction of pushes that stays.
  double take_gain(const UnknownsTable& before, const std::vector<std::size_t>& pushed,
                   UnknownsTable& velocities) const;

 private:
  std::size_t set_of(std::size_t contact) const;
  std::vector<double> taken_by(const std::vector<std::size_t>& contacts) const;

  const ClosingStep& of_;
  std::vector<std::size_t> numbers_;  ///< per element: lowest element of its set
  std::vector<bool> has_bond_;        ///< by the number of a set
};

/// Returns the energy that a contact took in closing, beyond the energy stored in its spring.
double energy_of_closing(const ClosingStep& of, std::size_t contact, const Table<VertexIndex, Point>& at_start,
                         const Table<VertexIndex, Point>& at_end);

}  // namespace keyblock
