// Reads the requested results of a sweep from the folders of its jobs.
// SPDX-License-Identifier: GPL-3.0-or-later
//
//   displacement, speed, state, steps, time, blocks    of the end of the run
//   fos, fos_joints, fos_rock, fos_both                largest stable factor of `keyblock fos`
//   point1.dx, point1.syy                              measured point 1: last row of points.csv
//   NAME.dx, NAME.vx, NAME.QUANTITY                    history with that name: last value in histories.csv
//   ledger.kinetic, history.dx1, step_table.residual   last row of a table
//   tip1.k1, tip1.k2, tip1.j, tip1.kink_deg            crack tip 1 of `keyblock sif`
//   /counts/most_contacts                              any value of run.json
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace keyblock::study {

/// Command whose results hold an output.
enum class SweepSource { run, fos, sif };

struct SweepOutput {
  std::string name;
  SweepSource source = SweepSource::run;
  std::string reduced = {};  ///< of a factor of safety: joints, rock, both; empty: as the case says
  std::string history = {};  ///< whose quantity it is; empty: of none
};

/// Parses a list of outputs, separated by commas. Throws std::invalid_argument for a name of none of these forms, and
/// for a column that no such table has.
std::vector<SweepOutput> sweep_outputs_of(const std::string& list);

/// Value of an output: a number or a text.
struct SweptValue {
  nlohmann::ordered_json value = {};
  std::string unit = {};  ///< as in the table or the record that has the value; empty: none
};

/// Results lack an output: "expected one of 2 tips, found tip3.k1".
struct OutputLacking : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Returns the value of an output of a run from its folder; null if a result without steps lacks it. Throws
/// OutputLacking if the run has results, and this is not one of them.
SweptValue value_of_run(const SweepOutput& output, const std::filesystem::path& folder);

/// Returns the largest stable factor in fos.json; null if there is none.
nlohmann::ordered_json value_of_fos(const std::string& fos_json);

/// Returns factor, verdict and reason of the last trial in fos.json; empty if there is none.
std::string last_trial_of(const std::string& fos_json);

/// Returns the value of a tip in the output of `keyblock sif --json`. Throws like `value_of_run`.
SweptValue value_of_sif(const SweepOutput& output, const std::string& sif_json);

}  // namespace keyblock::study
