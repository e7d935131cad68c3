// Collects warnings about the steps of a run; each kind is reported once, for its first or worst step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "job/run_report.hpp"
#include "job/verdict/block_watch.hpp"
#include "run/prepare.hpp"
#include "run/run.hpp"

namespace keyblock {

/// Kind of step that is reported once: the first one, or the one with the largest measure.
struct StepKind {
  const char* name;
  std::function<bool(const StepReport&)> concerns;
  /// Adds values of the reported step, beside its number, its time and the counts of steps. Returns the form.
  std::function<const char*(const StepReport& told, Facts& facts)> describe;
  std::function<double(const StepReport&)> measure = {};  ///< empty: the first one counts
};

/// Watches the steps of a run as they are reported.
class StepWatch {
 public:
  explicit StepWatch(const Prepared& prepared);

  void add(const StepReport& step);
  void describe(Archive& archive);

  /// Returns the warnings, at the place of the analysis.
  Warnings warnings(const Place& place) const;

  BlockWatch& blocks() { return blocks_; }
  bool is_static() const { return is_static_; }
  /// Returns nothing for dynamics, for blocks under Shi's rules, if points are driven, and before two creeping steps.
  std::optional<EquilibriumWay> equilibrium_way() const;

 private:
  struct Seen {
    StepReport told;
    int count = 0;  ///< steps concerned
  };

  Warnings far_from_equilibrium(const Place& place) const;

  BlockWatch blocks_;
  std::vector<StepKind> kinds_;
  std::vector<Seen> seen_;  ///< one per kind
  int steps_ = 0;
  bool is_static_ = false;
  bool creeps_ = false;    ///< static steps, each from zero velocity; the end need not be the equilibrium
  bool balances_ = false;  ///< each step is an equilibrium
  double way_ = 0;         ///< sum of the greatest displacements of the steps, over the allowed one
  double before_ = 0;      ///< displacement of the step before the last
  double last_ = 0;
};

/// Warns of an initial state that differs from the requested one, and of tables that end before the run does.
Warnings outcome_warnings(const Prepared& prepared, const RunOutcome& outcome, const Place& place);

/// Warns of bolts that broke between two frames.
Warnings broken_bolts(const Frame& first, const Frame& last, const Place& place);

}  // namespace keyblock
