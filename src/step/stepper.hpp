// What the run loop sees of a dynamics: a state, and a way to make the next step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <variant>

#include "result/ledger.hpp"
#include "result/start_report.hpp"
#include "step/advance.hpp"

namespace keyblock {

class Stepper {
 public:
  virtual ~Stepper() = default;

  /// At the end of the last accepted step.
  virtual const State& state() const = 0;
  /// Before any load: displacements are counted from here.
  virtual const State& unloaded() const = 0;
  virtual StartReport start_report() const { return {}; }
  /// On failure the state is unchanged.
  virtual std::variant<StepReport, StepFailure> advance() = 0;

  /// The books at the end of the last accepted step; of zeros where the settings keep none.
  virtual LedgerRow ledger() const = 0;
  virtual LedgerScope ledger_scope() const = 0;
};

/// The stepper of the scene's choice of dynamics; the scene must outlive it.
std::unique_ptr<Stepper> stepper_for(const Scene& scene);

}  // namespace keyblock
