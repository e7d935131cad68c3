// Shi's step behind the common face, and the choice between the dynamics.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/stepper.hpp"

#include "base/stop.hpp"
#include "step/describe_memory.hpp"
#include "step/shi_ledger.hpp"
#include "step/standard_stepper.hpp"

namespace keyblock {
namespace {

class ShiStepper : public Stepper {
 public:
  explicit ShiStepper(const Scene& scene)
      : scene_(scene), stepping_(start(scene)), unloaded_(places_of(stepping_.state)) {}
  ShiStepper(const Scene& scene, Archive& saved) : ShiStepper(scene) { describe(saved, stepping_); }

  const State& state() const override { return stepping_.state; }
  const StartPlaces& unloaded() const override { return unloaded_; }
  std::variant<StepReport, StepFailure> advance() override {
    const bool had_solved = stepping_.has_solved;
    const bool gave_up = stepping_.solver.gave_up_iterations;
    try {
      return keyblock::advance(scene_, stepping_);
    } catch (const StopRequested&) {
      stepping_.has_solved = had_solved;
      stepping_.solver.gave_up_iterations = gave_up;
      throw;
    }
  }
  LedgerRow ledger() const override { return stored_row(scene_.model, scene_.settings, state(), unloaded_); }
  LedgerScope ledger_scope() const override { return stored_scope(unloaded_); }
  void save(Archive& archive) override { describe(archive, stepping_); }

 private:
  const Scene& scene_;
  Stepping stepping_;
  StartPlaces unloaded_;
};

}  // namespace

std::unique_ptr<Stepper> stepper_for(const Scene& scene) {
  if (scene.settings.dynamics == Dynamics::standard) return std::make_unique<StandardStepper>(scene);
  return std::make_unique<ShiStepper>(scene);
}

std::unique_ptr<Stepper> restored_stepper(const Scene& scene, Archive& archive) {
  if (scene.settings.dynamics == Dynamics::standard) return std::make_unique<StandardStepper>(scene, archive);
  return std::make_unique<ShiStepper>(scene, archive);
}

}  // namespace keyblock
