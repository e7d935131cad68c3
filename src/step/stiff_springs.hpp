// Contact springs that are too stiff for the step to follow.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/smooth_solve.hpp"

namespace keyblock {

/// A step that is longer than this over the frequency of an oscillation does not follow it: the rate at the end of a step of
/// the trapezoidal rule has the sign of the one before up to here (amplification (4 − ω²dt²)/(4 + ω²dt²)).
inline constexpr double kFollowed = 2;
/// A rate whose mean over the step is a smaller share of that at its end than this has turned over with it; one that grows from
/// rest has half.
inline constexpr double kTurnedOver = 0.4;

/// The smooth motion of a step of `dt` from `start`; `closed`: which of its touches carry a force.
struct StiffSprings {
  const StandardScene& scene;
  const Motion& start;
  const SmoothMotion& smooth;
  const Touches& touches;
  const std::vector<bool>& closed;
  double dt = 0;
  double least_force = 0;  ///< smaller ones are none
};

/// v without what stiff springs have turned over. With ω dt > 2, ω² = Σp / m of a block, the trapezoidal rule gives the gap of
/// a closed spring at the end of each step the rate that it had before with the other sign: the block stays where it is, and
/// the force of the spring rises and falls by 2 m |v| / dt from step to step without end. Where most of the springs whose
/// rates matter have done so, all closed ones that are stiff act once more, as dashpots C = p dt² along the normals at the end of
/// the step,
///     (M + Gᵀ C G) v' = M v + Gᵀ C r,
/// with r the mean rate of the step for those that turned over, the rate at its end for the others: of what was turned over
/// 1 / (1 + C / m) is left. Dashpots may pull, for it is velocities that are mended, not forces. Closed touches without springs
/// and held points keep the rates that v has, springs of bodies on covers take no part. Cf. the projection of velocities
/// onto constraints that are kept in positions (Gear, Leimkuhler & Gupta 1985).
UnknownsTable eased(const StiffSprings& springs, UnknownsTable v);

}  // namespace keyblock
