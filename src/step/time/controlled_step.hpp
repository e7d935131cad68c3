// Makes a dynamic step in parts, with a part size adapted to the error. Theory: docs/theory/03-time-integration.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/time/standard_step.hpp"

namespace keyblock {

struct ControlledStep {
  StandardStep step;        ///< solves and discarded attempts of all parts
  double next = 0;          ///< first part of the next step
  double least = 0;         ///< smallest part made
  double displacement = 0;  ///< greatest of a vertex in one part
  int unresolved = 0;       ///< parts of the least size, accepted although the rule requests smaller ones
};

/// Steps from `time` to `time + interval`, beginning with a part of `first`; 0 lets the rule choose. Rule error: a part
/// is repeated if its error exceeds the tolerance. With a1 − a0 the change of acceleration in the part, the error of
/// position is c dt² (a1 − a0), c of the rule (Zienkiewicz & Xie 1991). An impact at an unknown time within the part
/// adds dt times the jump of velocity. Rule shi: sizes follow `next_step_size`, and a part that moves three times the
/// allowed displacement is repeated. A part without converged contact forces is cut too.
ControlledStep controlled_step(const StandardScene& scene, const Motion& start, double time, double interval,
                               double first);

/// Returns the greatest displacement of a vertex between two motions.
double greatest_displacement(const StandardScene& scene, const UnknownsTable& from, const UnknownsTable& to);

}  // namespace keyblock
