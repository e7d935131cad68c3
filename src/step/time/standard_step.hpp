// One step of Dynamics::standard: smooth motion, overlaps removed, impacts, clean-up.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "step/newton/newton.hpp"
#include "step/time/ledger.hpp"

namespace keyblock {

/// What a step did, beside the motion it led to.
struct StandardStep {
  Motion motion;
  StepAccount account;  ///< zero where no books are kept
  int solves = 0;
  int fallbacks = 0;        ///< solutions that needed a detour by the interior
  int halvings = 0;         ///< attempts thrown away because forces did not settle
  int locked_overlaps = 0;  ///< of impacts, left because other touches are in the way
  double least = 0;         ///< smallest part made of a step in time
  double struck = 0;        ///< how long before the end of the step its first impact was; 0: none
  double residual = 0;
  std::optional<Touch> worst;  ///< contact that holds the residual up, where one is known
  bool converged = true;
  RoundsEnd end = RoundsEnd::no_contact_forces;  ///< how its rounds ended, where it has not converged
  Touches touches;                               ///< all that were reckoned with
  std::vector<std::size_t> undecided;            ///< of the touches: those that went round in a cycle
  std::string failure;                           ///< why it was given up otherwise; empty if it was not
  std::vector<ElementIndex> moving;              ///< at rest: it was given up because these move away
  std::optional<ElementIndex> turned;            ///< it was given up because this one turned inside out
};

/// Of two parts of a step, the residual of the one that has the larger.
void keep_larger_residual(StandardStep& step, const StandardStep& other);

/// From `time` to `time + dt`. Where contact cannot be solved to its residual, the step is made in halves, and these in
/// halves again; then it is given up. Where few touch, it ends at its first impact, and what is
/// left of it is a part of its own, up to four times: contacts that an impact opens bear up to its instant.
StandardStep standard_step(const StandardScene& scene, const Motion& start, double time, double dt);

}  // namespace keyblock
