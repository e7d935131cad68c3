// Dynamics::standard as a stepper: start, step after step, and the state that observers see.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "step/stepper.hpp"
#include "step/time/controlled_step.hpp"

namespace keyblock {

class StandardStepper : public SceneStepper {
 public:
  /// Throws std::invalid_argument for a scene that is `unsupported`.
  explicit StandardStepper(Scene scene);
  /// Goes on in the scene that follows, from the motion and the time of the one before; its faces have these pulls.
  /// Throws as the first.
  StandardStepper(const StandardStepper& before, const SceneChange& change, std::vector<FacePull> pulls = {});
  /// As it was saved, of the same scene.
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
  /// A step in time whose pulls depend on where it ends: is asked after each trial, and puts other pulls and returns
  /// true where it wants another.
  using BetterPulls = std::function<bool(const CoverDisplacement& end, std::vector<FacePull>& pulls)>;
  std::variant<StepReport, StepFailure> advance(const BetterPulls& better);
  LedgerRow ledger() const override { return ledger_; }
  ContactFrames contacts() const override;
  StartReport start_report() const override { return start_report_; }
  std::optional<State> attempted() const override { return attempted_; }
  LedgerScope ledger_scope() const override { return keyblock::ledger_scope(scene_); }
  void save(Archive& archive) override { describe(archive); }

  std::unique_ptr<SceneStepper> in_next(const SceneChange& change) const override;
  bool is_at_rest(double share) const override;

  /// Of the coming steps.
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
  double next_part_ = 0;       ///< size of the first part of the coming step, under step control; 0: not chosen yet
  bool begins_scene_ = false;  ///< no step was made on it yet, and it is not the first
  StartReport start_report_;
  std::string start_failure_;  ///< said by the first step; empty for a start that was found
  std::optional<ElementIndex> turned_at_start_;
  StartPlaces unloaded_;
  State state_;
  Table<VertexIndex, Point> vertices_before_;  ///< at the start of the last step; none before one, or once restored
  LedgerRow ledger_;
  double plastic_work_ = 0;         ///< at rest, where there is no ledger of flows
  std::optional<State> attempted_;  ///< of a step that failed
};

/// The scene's state at a motion: vertices, carried points, stress turned into the plane, velocities.
State state_of(const StandardScene& scene, const Motion& motion);

}  // namespace keyblock
