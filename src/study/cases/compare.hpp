// Reruns a case in one or both profiles and holds the results against its expected values.
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

/// A case rerun once.
struct ComparedCase {
  std::string name;
  std::string profile;
  std::string variant;  ///< empty for the plain run
  std::string not_run;  ///< why there was no run: the profile refused the scene, or the case file says so
  std::vector<ComparedValue> values;
  RunOutcome outcome;
  Warnings warnings;
  Frame start;
  Frame end;
  std::vector<double> times;          ///< of every step, from 0
  std::vector<double> displacements;  ///< of the first block that is named, at those times
  int followed_block = 1;             ///< whose they are, from 1

  /// Nothing is judged, or the run finished and every judged value holds.
  bool holds() const;
};

/// A case rerun in every way asked for.
struct CaseComparison {
  std::string name;
  std::string about;
  std::vector<ComparedCase> plain;  ///< one a profile
  std::vector<ComparedCase> variants;

  bool holds() const;
};

/// The plain run under `profile`. A scene that the profile refuses is told in `not_run`. Throws InputError for
/// unreadable files, a quantity that is none, a block that is not there, or a setting of the case file that is none.
ComparedCase compare_case(const CaseFolder& folder, const std::string& profile);

/// The plain run under each profile, then the variants of these profiles. Throws as `compare_case`.
CaseComparison compare_in(const CaseFolder& folder, const std::vector<std::string>& profiles);

}  // namespace keyblock::study
