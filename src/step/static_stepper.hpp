// Holds the common part of static steppers of NMM bodies without contact: positions, step counter, bodies without
// support.
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

  /// Returns the position of the point that lay at `start` in the unloaded element.
  virtual Point place_of(ElementIndex e, Point start) const = 0;
  /// Returns the rotation of the element at that point [rad].
  virtual double rotation_of(ElementIndex e, Point start) const = 0;
  virtual void describe(Archive& archive) = 0;

  const Continuum& continuum() const { return *scene_.model.continuum; }
  /// Writes positions, stresses and measured points of the solution into the state; begin_unloaded does so before any
  /// load.
  void put_places();
  void begin_unloaded();
  /// Takes over the step number and time of the last scene.
  void continue_from(const StaticStepper& before);
  void describe_time(Archive& archive);
  /// Returns the failure of the next step if pieces have no support.
  std::optional<StepFailure> unheld_pieces() const;
  StepFailure failure(Finding why) const;
  /// Counts the next step as made and returns its report.
  StepReport end_step(int passes, int redos, double residual);

  Scene scene_;
  StartPlaces unloaded_;
  State state_;
};

}  // namespace keyblock
