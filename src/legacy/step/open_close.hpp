// Performs the open–close iteration: springs, solve, judge, until no contact opens or closes. Theory:
// docs/theory/13-shis-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "legacy/contact/judge.hpp"
#include "settings/settings.hpp"
#include "system/solve.hpp"

namespace keyblock {

/// Pass limit of the Berkeley loop, regardless of the limit in the file (legacy-rules 11.1).
inline constexpr int kBerkeleyPassBound = 8;

/// Residual, relative to the load, beyond which a solve is useless: the next step could not tell the error from a load.
/// It is well above round-off of a sound system (1e-12 … 1e-9) and well below engineering accuracy.
inline constexpr double kUselessResidual = 1e-6;

/// Position of the iteration within its step and its run.
enum class Attempt {
  first_of_run,  ///< its first solve is always repeated (legacy-rules 1.4)
  first_of_step,
  redone,  ///< no friction in its first pass (legacy-rules 9)
};

/// Result of the iteration.
struct OpenCloseOutcome {
  Contacts contacts;
  Increments increments;
  std::vector<Point> node_steps;  ///< of the nodes that elements share
  int passes = 0;
  double residual = 0;                      ///< largest relative residual of its solves
  std::vector<std::size_t> still_changing;  ///< contacts that changed in the last pass; empty if the iteration ended
  Finding failure;                          ///< reason why a solve was unusable; empty if none was
};

OpenCloseOutcome open_close(const System& without_contact, Contacts contacts, const Model& model, const State& state,
                            const Settings& settings, const ContactRules& rules, double penalty, double dt,
                            Attempt attempt, Solver& solver);

}  // namespace keyblock
