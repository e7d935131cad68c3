// The open-close iteration: springs, solve, judge, until no contact opens or closes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "contact/judge.hpp"
#include "model/settings.hpp"
#include "system/solve.hpp"

namespace keyblock {

/// Where the iteration stands within its step and its run.
enum class Attempt {
  first_of_run,  ///< its first solve is always repeated (legacy-rules 1.4)
  first_of_step,
  redone,  ///< no friction in its first pass (legacy-rules 9)
};

/// What the iteration ends with.
struct OpenCloseOutcome {
  Contacts contacts;
  Increments increments;
  int passes = 0;
  double residual = 0;                      ///< largest relative residual of its solves
  std::vector<std::size_t> still_changing;  ///< contacts that changed in the last pass: empty if the iteration ended
  bool solved = true;                       ///< false: a solve broke down
};

OpenCloseOutcome open_close(const System& without_contact, Contacts contacts, const Model& model, const State& state,
                            const Settings& settings, const ContactRules& rules, double penalty, Attempt attempt,
                            Solver& solver);

}  // namespace keyblock
