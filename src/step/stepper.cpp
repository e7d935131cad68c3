// Shi's step behind the common face, and the choice between the dynamics.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/stepper.hpp"

#include "step/shi_ledger.hpp"
#include "step/standard_stepper.hpp"

namespace keyblock {
namespace {

class ShiStepper : public Stepper {
 public:
  explicit ShiStepper(const Scene& scene) : scene_(scene), stepping_(start(scene)), unloaded_(stepping_.state) {}

  const State& state() const override { return stepping_.state; }
  const State& unloaded() const override { return unloaded_; }
  std::variant<StepReport, StepFailure> advance() override { return keyblock::advance(scene_, stepping_); }
  LedgerRow ledger() const override { return stored_row(scene_.model, scene_.settings, state(), unloaded_); }
  LedgerScope ledger_scope() const override { return stored_scope(unloaded_); }

 private:
  const Scene& scene_;
  Stepping stepping_;
  State unloaded_;
};

}  // namespace

std::unique_ptr<Stepper> stepper_for(const Scene& scene) {
  if (scene.settings.dynamics == Dynamics::standard) return std::make_unique<StandardStepper>(scene);
  return std::make_unique<ShiStepper>(scene);
}

}  // namespace keyblock
