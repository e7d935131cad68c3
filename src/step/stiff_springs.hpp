// Contact springs that are too stiff for the step to follow.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/smooth_solve.hpp"

namespace keyblock {

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

/// v without what stiff springs have turned over. With ω dt > 2, ω² = Σp / m of a block, the trapezoidal rule gives the gap of a closed spring
/// at the end of each step the rate that it had before with the other sign (amplification (4 − ω² dt²)/(4 + ω² dt²)): the block
/// stays where it is, and the force of the spring rises and falls by 2 m |v| / dt from step to step without end. Where a quarter of the springs
/// whose rates matter have done so, all closed ones that are stiff act once more as dashpots C = p dt² from the mean rates ḡ of
/// the step:
///     (M + Gᵀ C G) v' = M v + Gᵀ C ḡ,
/// which leaves 1 / (1 + C / m) of what was turned over; rates that a spring did follow, and those along the faces, stay as they
/// were but for what M couples. Bodies on covers are left as they are. Cf. the projection of velocities onto constraints that
/// are kept in positions (Gear, Leimkuhler & Gupta 1985).
UnknownsTable with_stiff_springs_at_ease(const StiffSprings& springs, UnknownsTable v);

}  // namespace keyblock
