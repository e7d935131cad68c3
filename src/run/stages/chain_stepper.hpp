// A chain of scenes as one stepper: each is stepped to its end, then the motion is carried into the next.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "step/stepper.hpp"

namespace keyblock {

class ChainStepper : public Stepper {
 public:
  /// Of a scene of dynamics `standard`. Throws std::invalid_argument for one that cannot be moved.
  explicit ChainStepper(Scene first);
  /// As it was saved, of the same chain. Throws InputError.
  ChainStepper(Scene first, Archive& saved);

  bool ends_scene() const override { return ends_scene_ || state().step == reports_.back().first_step; }
  bool is_done() const override { return ends_scene_ && !scene_.next; }
  std::vector<SceneReport> scenes() const override { return reports_; }
  const Model& model() const override { return now_->model(); }
  const Settings& settings() const override { return now_->settings(); }
  const State& state() const override { return now_->state(); }
  const StartPlaces& unloaded() const override { return now_->unloaded(); }
  Stress stress_at(ElementIndex e, Point start) const override { return now_->stress_at(e, start); }
  std::optional<PlasticState> plastic_at(ElementIndex e, Point start) const override {
    return now_->plastic_at(e, start);
  }
  std::optional<PlasticTotals> plastic_totals() const override { return now_->plastic_totals(); }
  std::optional<State> attempted() const override { return now_->attempted(); }
  ContactFrames contacts() const override { return now_->contacts(); }
  StartReport start_report() const override { return now_->start_report(); }
  std::variant<StepReport, StepFailure> advance() override;
  LedgerRow ledger() const override { return now_->ledger(); }
  LedgerScope ledger_scope() const override;
  void save(Archive& archive) override;

  std::optional<ForceBalance> forces() const override { return now_->forces(); }
  std::optional<CoverDisplacement> on_covers() const override { return now_->on_covers(); }
  std::vector<double> driven() const override { return now_->driven(); }

 private:
  void describe_chain(Archive& archive);
  void begin(const Scene& scene);
  void follow();

  Scene scene_;  ///< the present one
  LedgerScope scope_;
  std::unique_ptr<SceneStepper> now_;
  bool ends_scene_ = false;
  std::vector<SceneReport> reports_;  ///< that of the present scene is the last
};

}  // namespace keyblock
