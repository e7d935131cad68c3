// What the run loop sees of a dynamics: a state, and a way to make the next step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <variant>

#include "base/archive.hpp"
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
  virtual const StartPlaces& unloaded() const = 0;
  /// At the point of an element that lay at `start` before any load: on covers there, else that of the element.
  virtual Stress stress_at(ElementIndex e, Point) const { return state().elements[e].stress; }
  virtual StartReport start_report() const { return {}; }
  /// On failure the state is unchanged, and where it throws StopRequested in the middle of a step.
  virtual std::variant<StepReport, StepFailure> advance() = 0;

  /// The books at the end of the last accepted step; of zeros where the settings keep none.
  virtual LedgerRow ledger() const = 0;
  virtual LedgerScope ledger_scope() const = 0;

  /// Everything that the coming steps depend on. Saving changes nothing.
  virtual void save(Archive& archive) = 0;
};

/// The stepper of the scene's choice of dynamics; the scene must outlive it.
std::unique_ptr<Stepper> stepper_for(const Scene& scene);

/// The stepper as it was saved, of the same scene; its start is not searched again. Throws InputError.
std::unique_ptr<Stepper> restored_stepper(const Scene& scene, Archive& archive);

}  // namespace keyblock
