// Reruns a case in one or both profiles and holds the results against its expected values.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "result/frame.hpp"
#include "run/run.hpp"
#include "study/case_file.hpp"
#include "study/cases.hpp"
#include "study/expected.hpp"

namespace keyblock::study {

/// One row of expected.csv and what the run gave for it.
struct ComparedValue {
  std::string quantity;
  std::optional<int> block;  ///< or measured point, from 1, as in the file; none for the whole scene
  double time = 0;
  double expected = 0;
  std::optional<double> computed;  ///< none if the run did not reach the time
  double tolerance = 0;            ///< absolute
  std::string tolerance_reason;
  std::string source;
  std::string listed_miss;  ///< why it is known to miss; empty if it should hold
  bool is_judged = true;    ///< in this run; otherwise only shown

  double error() const { return computed.value_or(0) - expected; }
  bool holds() const;
  /// Judged and outside its tolerance without being listed, or within it although it is: then the list is out of date.
  bool is_missed() const { return is_judged && !is_listed_miss() && (!holds() || !listed_miss.empty()); }
  /// Computed, not held, and known not to hold.
  bool is_listed_miss() const;
};

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

/// The plain run under `profile`. A scene that the profile refuses is told in `not_run`. Throws InputError for unreadable
/// files, a quantity that is none, a block that is not there, or a setting of the case file that is none.
ComparedCase compare_case(const CaseFolder& folder, const std::string& profile);

/// The plain run under each profile, then the variants of these profiles. Throws as `compare_case`.
CaseComparison compare_in(const CaseFolder& folder, const std::vector<std::string>& profiles);

}  // namespace keyblock::study
