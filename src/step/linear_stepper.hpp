// Makes load steps of linear elastic NMM bodies without contact, except between the faces of one crack. Each scene is
// one static solution of the unloaded bodies. Theory: docs/theory/07-initial-state-and-statics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "step/bodies/linear_static.hpp"
#include "step/static_stepper.hpp"

namespace keyblock {

class LinearStepper : public StaticStepper {
 public:
  /// Takes a linear, undisplaced scene. Throws InputError if its initial stress is not finite.
  explicit LinearStepper(Scene scene);
  /// Restores the stepper from a checkpoint of the same scene. Throws InputError.
  LinearStepper(Scene scene, Archive& saved);

  Stress stress_at(ElementIndex e, Point start) const override;
  /// Solves the scene if it is not solved yet; its loads stay the same. Fails with the free motion if a body can still
  /// move, and if the forces between crack faces do not settle. Throws InputError if a load is not finite.
  std::variant<StepReport, StepFailure> advance() override;
  std::optional<ForceBalance> forces() const override;
  /// Returns the contacts between crack faces.
  ContactFrames contacts() const override;
  std::optional<CoverDisplacement> on_covers() const override {
    if (!solution_) return std::nullopt;
    return CoverDisplacement{solution_->basis, solution_->solution.x, false};
  }
  std::unique_ptr<SceneStepper> in_next(const SceneChange& change) const override;
  bool is_at_rest(double) const override { return true; }

 private:
  Point place_of(ElementIndex e, Point start) const override;
  double rotation_of(ElementIndex e, Point start) const override;
  void describe(Archive& archive) override;
  void describe_solution(Archive& archive);
  void describe_faces(Archive& archive);

  std::optional<ContinuumSolution> solution_;  ///< empty before the first step
};

}  // namespace keyblock
