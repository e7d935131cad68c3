// One run of a case under settings of its own: what it costs in processor time and what it gives.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "api/plan.hpp"
#include "study/cases/expected.hpp"

namespace keyblock::study {

/// A case that is to be run in many ways, read once.
struct StudyCase : OpenCase {
  std::vector<ExpectedValue> expected;  ///< reference of the runs; empty: the displacements at the end are taken
};

/// Reads the case of one folder (api/case_folder.hpp), or of the files of one. Throws InputError as reading does, and
/// for a folder of several cases.
StudyCase study_case(const std::vector<std::string>& paths);

/// A way to run a case.
struct RunPlan {
  std::string name;     ///< "rigid, step x2"
  std::string group;    ///< what is varied: "step", "basis and step", "profile"
  std::string profile;  ///< below the settings
  std::vector<Override> set;
  std::string coarser;  ///< name of the plan that this one refines, if any
  double growth = 1;    ///< at least so many times the cost of that one
};

struct RunLimits {
  int repeat = 1;           ///< the best of so many
  double cpu_seconds = 60;  ///< of one run; steps are not interrupted
};

enum class MeasuredEnd { finished, failed, refused, over_limit, stopped };

struct MeasuredRun {
  RunPlan plan;
  MeasuredEnd end = MeasuredEnd::finished;
  std::string reason;  ///< why there is no result
  /// Of processor time, all threads: start and steps, or load steps with their cutting, and finding a mesh by error;
  /// without reading.
  double seconds = 0;
  int timings = 0;  ///< the best of so many runs
  int steps = 0;
  int unknowns = 0;
  /// Of `expected` the values in order; without it displacements (x, y) at the end, of the measured points or else all
  /// blocks.
  std::vector<double> values;
};

/// A word for tables: "finished", "over limit".
std::string name_of(MeasuredEnd end);

/// Runs it, again until the times add up to 0.05 s. What goes wrong in the run is told in the result. Throws InputError
/// for expected values of blocks that are not there.
MeasuredRun measured_run(const StudyCase& chosen, const RunPlan& plan, const RunLimits& limits);

}  // namespace keyblock::study
