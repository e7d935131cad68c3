// Steps a chain of scenes: each to its end, then transfers the motion to the next.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "step/stepper_of_scenes.hpp"

namespace keyblock {

class ChainStepper : public StepperOfScenes {
 public:
  /// Takes a scene of dynamics `standard`. Throws std::invalid_argument if no stepper supports it.
  explicit ChainStepper(Scene first);
  /// Restores the stepper from a checkpoint of the same chain. Throws InputError.
  ChainStepper(Scene first, Archive& saved);

  bool ends_scene() const override { return ends_scene_ || state().step == reports_.back().first_step; }
  bool is_done() const override { return ends_scene_ && !scene_.next; }
  std::vector<SceneReport> scenes() const override { return reports_; }
  std::variant<StepReport, StepFailure> advance() override;
  LedgerScope ledger_scope() const override;
  void save(Archive& archive) override;

 private:
  const Stepper& now() const override { return *now_; }
  void describe_chain(Archive& archive);
  void begin(const Scene& scene);
  void follow();

  Scene scene_;  ///< current scene
  LedgerScope scope_;
  std::unique_ptr<SceneStepper> now_;
  bool ends_scene_ = false;
  std::vector<SceneReport> reports_;  ///< that of the current scene is the last
};

}  // namespace keyblock
