// Holds expected values and the values of a run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "result/frame.hpp"
#include "study/cases/expected.hpp"
#include "study/cases/quantities.hpp"

namespace keyblock::study {

/// One row of expected.csv with the value of the run.
struct ComparedValue {
  std::string quantity;
  std::optional<int> block;  ///< or measured point, from 1, as in the file; empty for the whole scene
  double time = 0;
  double expected = 0;
  std::optional<double> computed;  ///< empty if the run did not reach the time
  double tolerance = 0;            ///< absolute
  std::string tolerance_reason;
  std::string source;
  std::string listed_miss;  ///< reason of a known miss; empty if the value should hold
  bool is_judged = true;    ///< in this run; otherwise only shown

  double error() const { return computed.value_or(0) - expected; }
  bool holds() const;
  /// Returns true if a judged value is outside its tolerance without being listed. A listed one within its tolerance
  /// counts too: the list is then out of date.
  bool is_missed() const { return is_judged && !is_listed_miss() && (!holds() || !listed_miss.empty()); }
  /// Returns true if the value is computed, outside its tolerance, and listed as such.
  bool is_listed_miss() const;
};

/// Tolerance of equal instants, relative to the given step: the round-off of their sum.
inline constexpr double kSameInstant = 1e-3;

/// Returns the rows, none computed yet, judged as under `profile`.
std::vector<ComparedValue> values_to_find(const std::vector<ExpectedValue>& expected, const std::string& profile);

/// Throws InputError naming `file` if a value requests a measured point or a block that does not exist. `supports`:
/// prescribed displacements.
void require_numbers(const std::vector<ComparedValue>& values, const Model& model, const std::string& file);

/// Adds a frame and picks the values of its time, within `same` of it. Between two frames, as with automatic steps,
/// values are interpolated linearly.
void pick(std::vector<ComparedValue>& values, RunSoFar& run, const Frame& frame, double same);

}  // namespace keyblock::study
