// Reruns a case and holds the results against its expected values.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "result/frame.hpp"
#include "result/history.hpp"
#include "run/run.hpp"
#include "study/cases.hpp"

namespace keyblock::study {

/// One row of expected.csv and what the run gave for it.
struct ComparedValue {
  std::string quantity;
  std::optional<int> block;  ///< from 1, as in the file; none for the whole scene
  double time = 0;
  double expected = 0;
  std::optional<double> computed;  ///< none if the run did not reach the time
  double tolerance = 0;            ///< absolute
  std::string tolerance_reason;
  std::string source;

  double error() const { return computed.value_or(0) - expected; }
  bool holds() const;
};

/// A case rerun.
struct ComparedCase {
  std::string name;
  std::vector<ComparedValue> values;
  RunOutcome outcome;
  Warnings warnings;
  Frame start;
  Frame end;
  std::vector<double> times;          ///< of every step, from 0
  std::vector<double> displacements;  ///< of the block of the first row, at those times
  int followed_block = 1;             ///< whose they are, from 1

  bool holds() const;
};

/// Throws InputError for unreadable files, a quantity that is none, or a block that is not there.
ComparedCase compare_case(const CaseFolder& folder, const std::string& profile);

}  // namespace keyblock::study
