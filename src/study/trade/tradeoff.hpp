// Runs a case in many ways and reports cost and error of each.
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

/// Reference of the errors.
struct Reference {
  bool is_expected = false;      ///< the values of expected.csv; otherwise the limit of refined runs
  std::vector<double> values;    ///< in the order of MeasuredRun::values
  std::vector<double> scales;    ///< of expected values: divisors of the errors; 0: the value is ignored
  double uncertainty = 0;        ///< of a limit, relative: smaller errors are indistinguishable
  std::optional<double> order;   ///< observed, of a limit
  bool is_extrapolated = false;  ///< of a limit; otherwise it is the finest run itself
  std::string words;             ///< measure of the errors, one sentence
  std::string doubt;             ///< reason why a limit is not resolved; otherwise empty

  bool is_resolved() const { return doubt.empty(); }
  /// Returns the error below which errors are meaningless: 0 if the reference is resolved.
  double guessed_below() const;
};

/// Error below which all errors are equal: round-off of inputs and of solves.
inline constexpr double kLeastError = 1e-9;

struct Tradeoff {
  std::string name;
  Reference reference;
  std::vector<MeasuredRun> runs;
  std::vector<Price> prices;       ///< per run; errors include the uncertainty of the limit: true ones are no greater
  std::vector<std::size_t> front;  ///< cheapest first
  bool is_stopped = false;         ///< before all runs were made
};

/// Callback after every run, with the number of runs done and planned.
using OnRun = std::function<void(const MeasuredRun&, std::size_t done, std::size_t of)>;

/// Additions of a study to its plans: refinements (empty if impossible) that resolve the limit and meet the target or
/// use its budget. Without `refine` nothing is added.
struct Search {
  Wish wish;
  std::function<std::optional<RunPlan>(const RunPlan&, int parts)> refine = {};
};

/// Makes the runs of the plans. If the case expects no values, those of `limit_from` come first, coarsest first;
/// duplicates run once. A plan is left out if the coarser one shows it to exceed the limit; after a stop all are. Then
/// continues as `search` defines, each run within the limits. Throws std::runtime_error if the refined runs give no
/// limit.
Tradeoff tradeoff(const StudyCase& chosen, const std::vector<RunPlan>& plans, const std::vector<RunPlan>& limit_from,
                  const RunLimits& limits, const OnRun& on_run, const Search& search = {});

/// Returns the error of a run. With expected values it is the greatest error over its scale, otherwise the root mean
/// square over that of the reference. Infinite if a value was not reached.
double error_of(const MeasuredRun& run, const Reference& reference);

/// Returns the expected rows as a reference: those judged for `rules`, or all if no row is. The scale of a row is the
/// greatest expected value of its quantity and block. Rows that expect 0 count only if all do, against their tolerance.
Reference expected_reference(const std::vector<ExpectedValue>& expected, const std::string& rules);

}  // namespace keyblock::study
