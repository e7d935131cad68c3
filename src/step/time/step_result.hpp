// Holds the result of one step of Dynamics::standard.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "step/newton/newton.hpp"
#include "step/time/ledger.hpp"

namespace keyblock {

/// Result of a step. Residuals are over the largest load, times in [time].
struct StandardStep {
  Motion motion;
  StepAccount account;  ///< zero without an energy balance
  int solves = 0;
  int fallbacks = 0;        ///< solutions that needed a detour through the interior
  int halvings = 0;         ///< attempts discarded because forces did not settle
  int locked_overlaps = 0;  ///< of impacts, kept because other contacts are in the way
  double least = 0;         ///< smallest part of a dynamic step
  double struck = 0;        ///< time from the first impact to the end of the step; 0: no impact
  double residual = 0;
  std::optional<Touch> worst;  ///< contact with the largest residual, if known
  bool converged = true;
  RoundsEnd end = RoundsEnd::no_contact_forces;  ///< reason of the end of its iterations without convergence
  Touches touches;                               ///< all that were considered
  std::vector<std::size_t> undecided;            ///< of the contacts: those that cycled
  Finding failure;                               ///< other reason for the failure of the step; empty without failure
  std::vector<ElementIndex> moving;              ///< statics: the step failed because these move away
  std::optional<ElementIndex> turned;            ///< the step failed because this one turned inside out

  /// Sets the residual to the larger of both.
  void keep_larger_residual(const StandardStep& other) {
    if (!(other.residual > residual)) return;
    residual = other.residual;
    worst = other.worst;
  }
};

}  // namespace keyblock
