// Holds the motion of the bodies over a step without impacts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "contact/rows/gap.hpp"
#include "contact/solve/frictional_problem.hpp"
#include "step/bodies/integrator.hpp"
#include "step/newton/newton.hpp"
#include "step/scene/contact_laws.hpp"

namespace keyblock {

/// Residual of contact forces: the goal, and the value accepted if the goal is out of reach.
struct ForceTolerance {
  double goal = 0;
  double acceptable = 0;
  /// Residual with which the motion continues if no forces are acceptable; undecided contacts are reported.
  double tolerated = 0;
  /// Fraction of all three per element (set_shares.hpp); empty: the whole.
  std::vector<double> shares = {};

  double share_of(ElementIndex one, ElementIndex other) const {
    if (shares.empty()) return 1;
    return std::min(shares[static_cast<std::size_t>(one.value)], shares[static_cast<std::size_t>(other.value)]);
  }
};

/// Motion of the bodies at the end of the step, and the work of the solver.
struct SmoothMotion : BodiesMotion {
  Eigen::VectorXd forces;        ///< of the contacts: 2i normal, 2i + 1 tangential
  ContactRows rows;              ///< directions of the forces, at mid-step
  Flexibility flexibility;       ///< A⁻¹
  std::vector<ContactLaw> laws;  ///< per contact
  std::vector<bool> rate_laws;   ///< per contact: true if the force depends on the rate at the end, not on the gap
  std::vector<bool> way_laws;    ///< per contact: true if friction opposes the slip of the step, not its end velocity
  double residual = 0;
  Bonds bonds;                     ///< unbroken ones
  std::vector<Facing> overloaded;  ///< of them, if the rule of the step breaks none
  ConstraintMemory constraints;
  int rounds = 0;     ///< Newton iterations
  int solves = 0;     ///< linear systems factorised
  int fallbacks = 0;  ///< detours through the interior of the bounds
  bool converged = false;
  RoundsEnd end = RoundsEnd::open;     ///< reason of the end without convergence
  bool is_tolerated = false;           ///< converged only by the tolerated residual
  std::vector<std::size_t> undecided;  ///< contacts that did not settle
  std::optional<std::size_t> worst;    ///< contact with the largest residual, if the goal was not reached
};

/// Smooth motion of a step, or of a part of it, and its contacts.
struct ClosingStep {
  const StandardScene& scene;
  const Motion& start;
  const SmoothMotion& smooth;
  const StepRule& rule;
  const Scales& scales;
  const Touches& touches;
  const std::vector<double>& speeds;  ///< per contact: normal velocity at the start; 0 if no impact is possible
  const std::vector<bool>& closed;    ///< per contact: true if it bears or bonds
  double time = 0;
  double dt = 0;
  double whole = 0;  ///< whole step, of which this is a part
};

}  // namespace keyblock
