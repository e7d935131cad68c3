// What steppers of bodies on covers at rest, which nothing touches, have in common: places, steps, what moves freely.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "step/stepper.hpp"

namespace keyblock {

class StaticStepper : public SceneStepper {
 public:
  const Model& model() const override { return scene_.model; }
  const Settings& settings() const override { return scene_.settings; }
  const State& state() const override { return state_; }
  const StartPlaces& unloaded() const override { return unloaded_; }
  LedgerRow ledger() const override { return {}; }
  LedgerScope ledger_scope() const override { return {}; }
  void save(Archive& archive) override { describe(archive); }

 protected:
  explicit StaticStepper(Scene scene) : scene_(std::move(scene)) {}

  /// Where the point of an element lies that lay at `start` before any load.
  virtual Point place_of(ElementIndex e, Point start) const = 0;
  /// Rotation of the element at that point, rad.
  virtual double rotation_of(ElementIndex e, Point start) const = 0;
  virtual void describe(Archive& archive) = 0;

  const Continuum& continuum() const { return *scene_.model.continuum; }
  /// Puts places, stresses and measured points of the solution into the state; at the start they are the unloaded ones.
  void put_places();
  void begin_unloaded();
  /// At the step and time of the scene before.
  void continue_from(const StaticStepper& before);
  void describe_time(Archive& archive);
  /// Pieces that nothing holds, as the failure of the next step.
  std::optional<StepFailure> unheld_pieces() const;
  StepFailure failure(const std::string& why) const;
  /// The next step is made.
  StepReport end_step(int passes, int redos, double residual);

  Scene scene_;
  StartPlaces unloaded_;
  State state_;
};

}  // namespace keyblock
