// Steps a scene of Dynamics::standard: computes the initial state, makes each step and keeps the state for observers.
// Theory: docs/theory/03-time-integration.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "step/stepper.hpp"
#include "step/time/controlled_step.hpp"

namespace keyblock {

class StandardStepper : public SceneStepper {
 public:
  /// Computes the initial state. Throws std::invalid_argument if the scene is `unsupported`.
  explicit StandardStepper(Scene scene);
  /// Continues in the next scene, from the motion and time of `before`; `pulls` act on its faces. Throws
  /// std::invalid_argument if the scene is `unsupported`.
  StandardStepper(const StandardStepper& before, const SceneChange& change, std::vector<FacePull> pulls = {});
  /// Restores the stepper from a checkpoint of the same scene.
  StandardStepper(Scene scene, Archive& saved);

  const Model& model() const override { return scene_.model; }
  const Settings& settings() const override { return scene_.settings; }
  const State& state() const override { return state_; }
  const StartPlaces& unloaded() const override { return unloaded_; }
  std::optional<CoverDisplacement> on_covers() const override;
  Stress stress_at(ElementIndex e, Point start) const override;
  std::optional<PlasticState> plastic_at(ElementIndex e, Point start) const override;
  std::optional<PlasticTotals> plastic_totals() const override;
  std::variant<StepReport, StepFailure> advance() override { return advance({}); }
  /// Revises the pulls on faces that depend on the end of a dynamic step. Called after each trial. If it changes
  /// `pulls` and returns true, the step is tried again.
  using BetterPulls = std::function<bool(const CoverDisplacement& end, std::vector<FacePull>& pulls)>;
  std::variant<StepReport, StepFailure> advance(const BetterPulls& better);
  LedgerRow ledger() const override { return ledger_; }
  ContactFrames contacts() const override;
  std::function<ContactFrames()> contacts_later() const override;
  StartReport start_report() const override { return start_report_; }
  std::optional<State> attempted() const override { return attempted_; }
  LedgerScope ledger_scope() const override { return keyblock::ledger_scope(scene_); }
  void save(Archive& archive) override { describe(archive); }
  std::unique_ptr<SceneStepper> in_next(const SceneChange& change) const override;
  bool is_at_rest(double share) const override;

  /// Sets the pulls of all later steps.
  void put_pulls(std::vector<FacePull> pulls) { scene_.pulls = std::move(pulls); }
  const StandardScene& scene() const { return scene_; }
  const Motion& motion() const { return motion_; }

 private:
  void describe(Archive& archive);
  void describe_installed(Archive& archive);
  void book_change(const LedgerRow& before);
  ControlledStep make_step();
  ControlledStep make_step(const BetterPulls& better);
  void book(const StandardStep& step);

  StandardScene scene_;
  Motion motion_;
  double next_part_ = 0;       ///< size of the first part of the next step, under step control; 0: not chosen yet
  bool begins_scene_ = false;  ///< true in a later scene before its first step
  StartReport start_report_;
  std::string start_failure_;  ///< reported by the first step; empty if an initial state was found
  std::optional<ElementIndex> turned_at_start_;
  StartPlaces unloaded_;
  State state_;
  Table<VertexIndex, Point> vertices_before_;  ///< at the start of the last step; empty before one and after restart
  LedgerRow ledger_;
  double plastic_work_ = 0;         ///< statics only, which has no energy balance
  std::optional<State> attempted_;  ///< end of a failed step
};

/// Returns the state of the scene at a motion: vertices, carried points, stress rotated into the plane, velocities.
State state_of(const StandardScene& scene, const Motion& motion);

}  // namespace keyblock
