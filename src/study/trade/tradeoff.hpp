// A case run in many ways: what each costs and how far off it is.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/trade/measured_run.hpp"
#include "study/trade/price.hpp"

namespace keyblock::study {

/// What errors are measured against.
struct Reference {
  bool is_expected = false;      ///< the values of expected.csv; otherwise the limit of refined runs
  std::vector<double> values;    ///< in the order of MeasuredRun::values
  std::vector<double> scales;    ///< of expected values: an error is divided by it; 0: the value is not looked at
  double uncertainty = 0;        ///< of a limit, relative: errors below it are not told apart
  std::optional<double> order;   ///< observed, of a limit
  bool is_extrapolated = false;  ///< of a limit; otherwise it is the finest run itself
  std::string words;             ///< how errors are measured, one sentence
  std::string doubt;             ///< why a limit is not resolved; empty where it is

  bool is_resolved() const { return doubt.empty(); }
  /// Errors below it say nothing: 0 where the reference is resolved.
  double guessed_below() const;
};

/// Below it all errors count the same: round-off of inputs and of solves.
inline constexpr double kLeastError = 1e-9;

struct Tradeoff {
  std::string name;
  Reference reference;
  std::vector<MeasuredRun> runs;
  std::vector<Price> prices;       ///< of the runs; errors with what the limit may be off: the true ones are no greater
  std::vector<std::size_t> front;  ///< cheapest first
  bool is_stopped = false;         ///< before all runs were made
};

/// Told of every run: how many are done, of how many.
using OnRun = std::function<void(const MeasuredRun&, std::size_t done, std::size_t of)>;

/// What a study may add to its plans: refinements of them (nothing where there is none), so that the limit is resolved
/// and the wish is met or its budget used. Without `refine` nothing is added.
struct Search {
  Wish wish;
  std::function<std::optional<RunPlan>(const RunPlan&, int parts)> refine = {};
};

/// Runs the plans, and before them those of `limit_from`, coarsest first, where the case expects no values; what both
/// hold is run once. A plan that refines another is left out where that one shows it to be over the limit, and all are
/// once a stop is asked for. Then goes on as `search` says, each run within the limits. Throws std::runtime_error where
/// the refined runs give no limit.
Tradeoff tradeoff(const StudyCase& chosen, const std::vector<RunPlan>& plans, const std::vector<RunPlan>& limit_from,
                  const RunLimits& limits, const OnRun& on_run, const Search& search = {});

/// Of the values of a run: with expected values the greatest error over its scale, else root mean square over that of
/// the reference. Infinite where a value was not reached.
double error_of(const MeasuredRun& run, const Reference& reference);

/// The expected rows as a reference: those judged for `rules` (all, where none is). The scale of a row is the greatest
/// value expected of its quantity and block; rows that expect 0 are looked at only where all do, against their
/// tolerance.
Reference expected_reference(const std::vector<ExpectedValue>& expected, const std::string& rules);

}  // namespace keyblock::study
