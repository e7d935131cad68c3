// Expected values and what a run gave for them.
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

/// Instants this near to each other, as a share of the given step, are the same up to the round-off of their sum.
inline constexpr double kSameInstant = 1e-3;

/// The rows, none computed yet, judged as `profile` is.
std::vector<ComparedValue> values_to_find(const std::vector<ExpectedValue>& expected, const std::string& profile);

/// Throws InputError naming `file` where a value asks for a measured point or a block that is not there.
/// `supports`: prescribed displacements.
void require_numbers(const std::vector<ComparedValue>& values, const Model& model, const std::string& file);

/// Takes in a frame and picks the values of its time, which instants within `same` of it have; between two frames, as
/// automatic steps have them, values are linear.
void pick(std::vector<ComparedValue>& values, RunSoFar& run, const Frame& frame, double same);

}  // namespace keyblock::study
