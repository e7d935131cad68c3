// Computes the motion of a step without impacts: bodies under loads, with closed and slowly closing contacts. Theory:
// docs/theory/05-frictional-contact.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

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
  Bonds bonds;  ///< unbroken ones
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

/// Solves the step. It has weights θv of the velocity and θf of the elastic force (Moreau 1988 for the half weights,
/// Shi 1988 for ½ and 1):
///     A Δq = r + Gᵀ λ,  A = M/(θv dt²) + θf K + C/dt,  r = F − K q0 + M v0/(θv dt),  v1 = (Δq/dt − (1−θv) v0)/θv.
/// The normal law holds for positions at the end of the step, friction for velocities, G along the mid-step normal
/// (Moreau 1988, Jean 1999). With springs, both have the compliance of the spring. Bolts and fixed points are included.
/// `before`: solution of the same step with only the first contacts, if there is one; its forces are the first guess.
SmoothMotion smooth_solve(const StandardScene& scene, const Motion& start, const UnknownsTable& loads,
                          const Touches& touches, const ForceTolerance& tolerance, double time, double dt,
                          const StepRule& rule, const SmoothMotion* before = nullptr);

}  // namespace keyblock
