// Computes the motion of a step without impacts: bodies under loads, with closed and slowly closing contacts. Theory:
// docs/theory/05-frictional-contact.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/time/smooth_motion.hpp"

namespace keyblock {

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
