// Kills runs at random moments, resumes them and compares them with an undisturbed run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace keyblock::support {

/// Returns every file below a folder with its bytes, without the timings of run.json.
std::map<std::string, std::string> contents(const std::string& folder);

struct KilledRuns {
  int killed = 0;        ///< number of runs that were still running at their moment
  int resumed = 0;       ///< number of these that had begun to write into their folder; the others were repeated
  int killed_twice = 0;  ///< number of these that were killed again and resumed again
  std::string differs;   ///< first file that differs, or the message of a program that failed; empty if all files agree
};

/// Runs `keyblock run ARGUMENTS…` at least `moments` times, and more often until one run was resumed. Each run is
/// killed at a random moment of its length, resumed, and compared with the whole run. Every third run is killed once
/// more on its way, and each part uses another number of threads. `seed` fixes the random numbers.
KilledRuns killed_runs(const std::vector<std::string>& arguments, int moments, unsigned seed);

}  // namespace keyblock::support
