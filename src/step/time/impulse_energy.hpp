// Keeps impulses with rebound from making energy. Theory: docs/theory/06-impact.md, 6.3.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "contact/solve/frictional_problem.hpp"
#include "step/scene/standard_scene.hpp"

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

}  // namespace keyblock
