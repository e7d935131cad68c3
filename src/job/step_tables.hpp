// Writes the kept rows of steps as the table step_table.csv, whose columns run.json names.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/run_choices.hpp"
#include "result/step_record.hpp"

namespace keyblock {

/// Returns the columns: step, time, dt, passes, redos, fallbacks, contacts, closed, penalty, greatest_penetration,
/// displacement_ratio, residual, unsettled_contacts. They have units if the case declares them. Load steps of
/// elastoplastic rock also have `parts`; their passes are Newton iterations, their redos are cuts.
std::vector<std::string> step_columns(const std::vector<StepReport>& rows, const Units& units);

/// Returns the rows under these column names.
std::string step_table_csv(const std::vector<StepReport>& rows, const Units& units);

}  // namespace keyblock
