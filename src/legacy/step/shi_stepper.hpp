// Steps a scene by Shi's rules. Theory: docs/theory/13-shis-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/step/advance.hpp"

namespace keyblock {

class ShiStepper : public Stepper {
 public:
  explicit ShiStepper(Scene scene);
  /// Restores the stepper from a checkpoint of the same scene. Throws InputError.
  ShiStepper(Scene scene, Archive& saved);

  const Model& model() const override { return scene_.model; }
  const Settings& settings() const override { return scene_.settings; }
  const State& state() const override { return stepping_.state; }
  const StartPlaces& unloaded() const override { return unloaded_; }
  std::variant<StepReport, StepFailure> advance() override;
  ContactFrames contacts() const override;
  LedgerRow ledger() const override;
  LedgerScope ledger_scope() const override;
  void save(Archive& archive) override;

 private:
  ShiScene scene_;
  Stepping stepping_;
  StartPlaces unloaded_;
  Table<VertexIndex, Point> vertices_before_;  ///< at the start of the last step; empty before one and after restart
};

}  // namespace keyblock
