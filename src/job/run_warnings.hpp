// What a reader of the results must know and would not see: said once, with the first or the worst step concerned.
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

/// A kind of step of which something is said once: of the first, or of the one that measures most.
struct StepKind {
  const char* name;
  std::function<bool(const StepReport&)> concerns;
  std::function<std::string(const StepReport& told, int concerned, int steps)> sentence;
  std::function<double(const StepReport&)> measure = {};  ///< empty: the first is told
};

/// Watches the steps of a run as they are told.
class StepWatch {
 public:
  explicit StepWatch(const Prepared& prepared);

  void add(const StepReport& step);
  void describe(Archive& archive);

  /// At the place of the analysis.
  Warnings warnings(const Place& place) const;

  BlockWatch& blocks() { return blocks_; }
  bool is_static() const { return is_static_; }
  /// None for dynamics, for blocks under the old rules, where points are driven, and before two steps that creep.
  std::optional<EquilibriumWay> equilibrium_way() const;

 private:
  struct Seen {
    StepReport told;
    int count = 0;  ///< steps concerned
  };

  Warnings far_from_equilibrium(const Place& place) const;

  BlockWatch blocks_;
  std::vector<StepKind> kinds_;
  std::vector<Seen> seen_;  ///< one a kind
  int steps_ = 0;
  bool is_static_ = false;
  bool creeps_ = false;    ///< static steps, each from rest, towards one equilibrium: their last frame need not be it
  bool balances_ = false;  ///< each step is an equilibrium
  double way_ = 0;         ///< sum of the greatest displacements of the steps, over the allowed one
  double before_ = 0;      ///< that of the last step but one
  double last_ = 0;
};

/// Of a start not as asked, and of tables that end before the run does.
Warnings outcome_warnings(const Prepared& prepared, const RunOutcome& outcome, const Place& place);

/// Of bolts that broke between two frames.
Warnings broken_bolts(const Frame& first, const Frame& last, const Place& place);

}  // namespace keyblock
