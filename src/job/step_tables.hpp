// The rows of steps that a run keeps, as a table: step_table.csv, whose columns run.json names.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/run_choices.hpp"
#include "result/step_record.hpp"

namespace keyblock {

/// step, time, dt, passes, redos, fallbacks, contacts, closed, penalty, greatest_penetration, displacement_ratio,
/// residual, unsettled_contacts, with their units where the case declares them, and, of load steps of rock that may
/// yield, parts. Passes of those are rounds of Newton's method, redos are cuts.
std::vector<std::string> step_columns(const std::vector<StepReport>& rows, const Units& units);

/// Under these names.
std::string step_table_csv(const std::vector<StepReport>& rows, const Units& units);

}  // namespace keyblock
