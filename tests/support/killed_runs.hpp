// Runs killed at random moments and resumed, held against the run that was left alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace keyblock::support {

/// Every file below a folder with its bytes; the timings of run.json are left out.
std::map<std::string, std::string> contents(const std::string& folder);

struct KilledRuns {
  int killed = 0;        ///< runs that still ran at their moment
  int resumed = 0;       ///< of those, the ones that had begun to write into their folder; the others were asked again
  int killed_twice = 0;  ///< of those, how often the run was killed again and resumed again
  std::string
      differs;  ///< the first file that is another, or the message of a program that failed; empty if all is the same
};

/// Runs of `keyblock run ARGUMENTS…`, at least `moments` and more until one was resumed, each killed at a random moment
/// of its length, resumed, and compared to the whole run; every third is killed once more on the way, and each part is
/// on another number of threads. The dice are those of `seed`.
KilledRuns killed_runs(const std::vector<std::string>& arguments, int moments, unsigned seed);

}  // namespace keyblock::support
