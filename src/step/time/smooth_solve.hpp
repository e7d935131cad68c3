// The motion of a step without impacts: elastic blocks under loads, with the contacts that close slowly or are closed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "contact/rows/gap.hpp"
#include "contact/solve/frictional_problem.hpp"
#include "step/bodies/integrator.hpp"
#include "step/newton/newton.hpp"
#include "step/scene/contact_laws.hpp"

namespace keyblock {

/// Residual of contact forces: the one to reach, and the one that counts as solved where it is out of reach.
struct ForceTolerance {
  double goal = 0;
  double acceptable = 0;
  /// Residual with which the motion goes on where no forces are acceptable; undecided touches are told.
  double tolerated = 0;
};

/// Of the bodies at the end of the step, and what it took.
struct SmoothMotion : BodiesMotion {
  Eigen::VectorXd forces;        ///< of the touches: 2i normal, 2i + 1 tangential
  ContactRows rows;              ///< that the forces act along, at mid-step
  Flexibility flexibility;       ///< A⁻¹
  std::vector<ContactLaw> laws;  ///< of the touches
  std::vector<bool> rate_laws;   ///< of the touches: whether the force is that of the rate at the end, not of the gap
  std::vector<bool> way_laws;    ///< of the touches: whether friction is against the slip of the step, not its end
  double residual = 0;
  Bonds bonds;  ///< that still hold
  ConstraintMemory constraints;
  int rounds = 0;     ///< of Newton's method
  int solves = 0;     ///< linear systems factorised
  int fallbacks = 0;  ///< detours by the interior of the bounds
  bool converged = false;
  RoundsEnd end = RoundsEnd::open;     ///< how the rounds ended, where it has not converged
  bool is_tolerated = false;           ///< converged by what is tolerated alone
  std::vector<std::size_t> undecided;  ///< touches that would not settle
  std::optional<std::size_t> worst;    ///< touch that holds the residual up, where the goal was not reached
};

/// With weights θv of the velocity and θf of the elastic force (Moreau 1988 for the half weights, Shi 1988 for ½ and
/// 1),
///     A Δq = r + Gᵀ λ,  A = M/(θv dt²) + θf K + C/dt,  r = F − K q0 + M v0/(θv dt),  v1 = (Δq/dt − (1−θv) v0)/θv.
/// The normal law is in positions at the end of the step, friction in velocities, G along the mid-step normal
/// (Moreau 1988, Jean 1999); with springs, both have the compliance of the spring. Bolts and held points are part of
/// it. `before`: of the same step with the first of the touches alone, where it has been solved so; its forces are
/// tried first.
SmoothMotion smooth_solve(const StandardScene& scene, const Motion& start, const UnknownsTable& loads,
                          const Touches& touches, const ForceTolerance& tolerance, double time, double dt,
                          const StepRule& rule, const SmoothMotion* before = nullptr);

}  // namespace keyblock
