// Builds the record of a run, run.json: inputs, choices and results. Its keys are stable.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "job/run_record.hpp"
#include "run/prepare.hpp"

namespace keyblock {

/// "no_equilibrium", "undecided" or "cracks".
const char* word_for(FailureKind kind);

/// Option of `run`, and its effect with the verb first: "shows the motion".
struct Remedy {
  std::string option;
  std::string what;
};

/// Returns options to try after a failed run; empty if no remedy is known.
std::vector<Remedy> what_to_try(const Prepared& prepared, const RunOutcome& outcome);

nlohmann::ordered_json inputs_json(const std::vector<InputRecord>& inputs);

/// Returns every warning with its place and its values.
nlohmann::ordered_json warning_list_json(const Warnings& warnings);

/// Returns the changed values by their pointers; an empty object if there are none.
nlohmann::ordered_json values_json(const std::vector<ChangedValue>& values);

/// Returns name, count and first occurrence of each kind of warning, with the values of the first.
nlohmann::ordered_json warnings_json(const Warnings& warnings);

/// Returns every setting by its name.
nlohmann::ordered_json all_settings_json(const Settings& settings);
nlohmann::ordered_json settings_json_of(const std::vector<SettingText>& settings);

/// Returns the plan of a study: `program`, `version`, `case`, `profile`, `profile_because`, `unknowns` and `settings`,
/// as check and run.json have them. `name`: of the case.
nlohmann::ordered_json plan_json(const std::string& name, const ChosenProfile& profile, const Prepared& prepared);

nlohmann::ordered_json requirements_json(const Requirements& requirements);

nlohmann::ordered_json run_json(const Prepared& prepared, const RunRecord& record);

}  // namespace keyblock
