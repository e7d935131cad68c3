// A step in time made in parts, whose size is chosen by what each part shows.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/time/standard_step.hpp"

namespace keyblock {

struct ControlledStep {
  StandardStep step;        ///< solves and thrown-away attempts of all parts
  double next = 0;          ///< part to begin the next step with
  double least = 0;         ///< smallest part made
  double displacement = 0;  ///< greatest of a vertex in one part
  int unresolved = 0;       ///< parts of the least size, accepted though the rule asks for smaller ones
};

/// From `time` to `time + interval`, beginning with a part of `first`; 0 lets the rule choose.
/// Rule error: a part is made again if its error passes the tolerance. With a1 − a0 the change of acceleration in the
/// part, its position is wrong by c dt² (a1 − a0), c of the rule (Zienkiewicz & Xie 1991), and by dt times the jump of
/// its velocity, since an impact happens somewhere within. Rule shi: that of `next_step_size`, and a part that moves
/// three times the allowed displacement is made again. Where contact cannot be solved the part is cut too.
ControlledStep controlled_step(const StandardScene& scene, const Motion& start, double time, double interval,
                               double first);

/// Greatest displacement of a vertex between two motions.
double greatest_displacement(const StandardScene& scene, const UnknownsTable& from, const UnknownsTable& to);

}  // namespace keyblock
