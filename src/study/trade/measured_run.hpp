// Runs a case under its own settings and measures its processor time and results.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "api/plan.hpp"
#include "study/cases/expected.hpp"

namespace keyblock::study {

/// Case to be run in many ways, read once.
struct StudyCase : OpenCase {
  std::vector<ExpectedValue> expected;  ///< reference of the runs; empty: the displacements at the end are taken
};

/// Reads the case of one folder (api/case_folder.hpp), or of its files. Throws InputError as reading does, and for a
/// folder of several cases.
StudyCase study_case(const std::vector<std::string>& paths);

/// One way to run a case.
struct RunPlan {
  std::string name;     ///< "rigid, step x2"
  std::string group;    ///< varied choices: "step", "basis and step", "profile"
  std::string profile;  ///< below the settings
  std::vector<Override> set;
  std::string coarser;  ///< name of the plan that this one refines, if any
  double growth = 1;    ///< least cost over that of the coarser one
};

struct RunLimits {
  int repeat = 1;           ///< number of runs of which the best counts
  double cpu_seconds = 60;  ///< of one run; steps are not interrupted
};

enum class MeasuredEnd { finished, failed, refused, over_limit, stopped };

struct MeasuredRun {
  RunPlan plan;
  MeasuredEnd end = MeasuredEnd::finished;
  std::string reason;  ///< reason for a missing result
  /// Processor time of all threads [s]: start and steps, or load steps with their cutting, and the search of a mesh by
  /// error. Reading is excluded.
  double seconds = 0;
  int timings = 0;  ///< number of runs of which the best counts
  int steps = 0;
  int unknowns = 0;
  /// Values of `expected` in order. Without it, displacements (x, y) at the end, of the measured points or else of all
  /// blocks.
  std::vector<double> values;
};

/// Returns a word for tables: "finished", "over limit".
std::string name_of(MeasuredEnd end);

/// Runs the plan, repeatedly until the times add up to 0.05 s. Failures of the run are reported in the result. Throws
/// InputError for expected values of missing blocks.
MeasuredRun measured_run(const StudyCase& chosen, const RunPlan& plan, const RunLimits& limits);

}  // namespace keyblock::study
