// Reruns a case in one or both profiles and compares the results with its expected values.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "api/case_file.hpp"
#include "api/case_folder.hpp"
#include "base/error.hpp"
#include "result/frame.hpp"
#include "run/run.hpp"
#include "study/cases/compared_values.hpp"

namespace keyblock::study {

/// One rerun of a case.
struct ComparedCase {
  std::string name;
  std::string profile;
  std::string variant;  ///< empty for the plain run
  std::string not_run;  ///< reason why there was no run: the profile refused the scene, or the case file excludes it
  std::vector<ComparedValue> values;
  RunOutcome outcome;
  Warnings warnings;
  Frame start;
  Frame end;
  std::vector<double> times;          ///< of every step, from 0
  std::vector<double> displacements;  ///< of the first named block, at those times
  int followed_block = 1;             ///< that block, from 1

  /// Returns true if no value is judged, or if the run finished and every judged value is within its tolerance.
  bool holds() const;
};

/// All requested reruns of a case.
struct CaseComparison {
  std::string name;
  std::string about;
  std::vector<ComparedCase> plain;  ///< one per profile
  std::vector<ComparedCase> variants;

  bool holds() const;
};

/// Makes the plain run under each profile, then the variants of these profiles. A refusal of the scene by a profile is
/// reported in `not_run`. Throws InputError for unreadable files, an unknown quantity, a missing block, or an invalid
/// setting of the case file.
CaseComparison compare_in(const CaseFolder& folder, const std::vector<std::string>& profiles);

}  // namespace keyblock::study
