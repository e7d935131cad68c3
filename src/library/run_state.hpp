// Declares the state behind a public run: what steps it, and what its callers may read.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <keyblock/record.hpp>
#include <memory>
#include <string>

#include "job/run_account.hpp"
#include "library/parts.hpp"
#include "step/stepper.hpp"

namespace keyblock::api {

/// Returns the end of a run with its doubts.
Outcome outcome_of(const Prepared& prepared, const RunRecord& record);

Step step_of(const StepReport& report);

inline namespace v1 {

/// A run between two steps. One kind steps in memory, the other writes its results into a folder.
struct Run::State {
  State(Case of, std::shared_ptr<const PlannedCase> plan, std::shared_ptr<RunAccount> kept,
        const keyblock::Context& under)
      : of_case(std::move(of)), planned(std::move(plan)), account(std::move(kept)), context(under) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  virtual ~State() = default;

  /// Makes a step; false at the end, a failure or a stop.
  virtual bool step() = 0;
  /// Sets the outcome after the last step.
  virtual void end() = 0;
  virtual bool is_recorded() const { return false; }
  /// Prepares a recorded run to end before its next step.
  virtual void end_early(const std::string&) {}

  /// Makes a step, and `end` after the last.
  bool advance();
  /// Returns the contacts of now, which all frames of this step share.
  const std::shared_ptr<Contacts>& contacts_now();

  Case of_case;
  std::shared_ptr<const PlannedCase> planned;
  std::shared_ptr<RunAccount> account;
  keyblock::Context context;
  std::shared_ptr<Stepper> stepper;
  LedgerScope scope;  ///< of the energy balance
  Step last;
  Outcome outcome;

 private:
  void leave_step();

  std::shared_ptr<Contacts> contacts_of_now_;
};

}  // namespace v1
}  // namespace keyblock::api
