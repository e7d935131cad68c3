// Performs one job of a sweep: a folder with processes of `keyblock run`, `fos` and `sif` under the values of a row.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/batch/child_process.hpp"
#include "app/input/case_options.hpp"
#include "base/context.hpp"
#include "study/sweep/sweep_design.hpp"
#include "study/sweep/sweep_outputs.hpp"
#include "study/sweep/sweep_table.hpp"

namespace keyblock {

/// Choices that all jobs of a sweep share.
struct SweepPlan {
  CaseOptions given;
  std::string joints;                  ///< text of the joint statistics, as JSON; empty: none
  std::vector<std::string> histories;  ///< in the form of `keyblock run --history`
  std::vector<study::SweepOutput> outputs;
  std::optional<double> within;  ///< width of the bracket of a factor of safety
  ChildLimits limits;
  std::filesystem::path folder;  ///< for results

  std::filesystem::path folder_of(const std::string& job) const { return folder / "jobs" / job; }
};

/// Returns the result of the row. A run that an earlier sweep left unfinished goes on from its checkpoint. Nothing if
/// `stop` ended the job. Throws OutputError.
std::optional<study::SweepResult> do_sweep_job(const SweepPlan& plan, const study::SweepRow& row, const Context& stop);

}  // namespace keyblock
