// Formats the results of a run in a few aligned rows for the terminal.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "job/run_report.hpp"
#include "run/prepare.hpp"

namespace keyblock {

/// Returns "finished in 0.4 s: 300 steps, t = 0.3 s", also for a run that failed or was stopped.
std::string end_in_words(const RunRecord& record);

/// Returns one row per result: motion, largest displacement, stresses, contacts, energy; and, if the run has them,
/// stages, forces, yielded rock and limit loads. Empty for a run without a step.
std::vector<std::string> summary_rows(const Prepared& prepared, const RunRecord& record);

/// Returns the work of the solver: "solver: 1.2 linear solves per step on average, 4 at most; 1 to 3 in 299 steps".
std::string solver_in_words(const Settings& settings, const StepTotals& totals);

}  // namespace keyblock
