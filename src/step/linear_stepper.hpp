// Load steps of bodies on covers that nothing touches: each is one linear static solution of the unloaded bodies.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "step/bodies/linear_static.hpp"
#include "step/stepper.hpp"

namespace keyblock {

class LinearStepper : public SceneStepper {
 public:
  /// Of a scene that is linear, undisplaced. Throws InputError where its initial stress has no finite value.
  explicit LinearStepper(Scene scene);
  /// As it was saved, of the same scene. Throws InputError.
  LinearStepper(Scene scene, Archive& saved);

  const Model& model() const override { return scene_.model; }
  const Settings& settings() const override { return scene_.settings; }
  const State& state() const override { return state_; }
  const StartPlaces& unloaded() const override { return unloaded_; }
  Stress stress_at(ElementIndex e, Point start) const override;
  /// Solves where the scene has not been solved yet: its loads stay the same. Fails where a body can still move, with
  /// the motion. Throws InputError where a load has no finite value.
  std::variant<StepReport, StepFailure> advance() override;
  LedgerRow ledger() const override { return {}; }
  LedgerScope ledger_scope() const override { return {}; }
  std::optional<ForceBalance> forces() const override;
  void save(Archive& archive) override { describe(archive); }
  std::unique_ptr<SceneStepper> in_next(const SceneChange& change) const override;
  bool is_at_rest(double) const override { return true; }

 private:
  const Continuum& continuum() const { return *scene_.model.continuum; }
  void describe(Archive& archive);
  void describe_solution(Archive& archive);
  void put_places();

  Scene scene_;
  std::optional<ContinuumSolution> solution_;  ///< none before the first step
  StartPlaces unloaded_;
  State state_;
};

}  // namespace keyblock
