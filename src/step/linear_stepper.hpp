// Load steps of bodies on covers that nothing touches but faces of cracks each other: each is one static solution of
// the unloaded bodies.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "step/bodies/linear_static.hpp"
#include "step/static_stepper.hpp"

namespace keyblock {

class LinearStepper : public StaticStepper {
 public:
  /// Of a scene that is linear, undisplaced. Throws InputError where its initial stress has no finite value.
  explicit LinearStepper(Scene scene);
  /// As it was saved, of the same scene. Throws InputError.
  LinearStepper(Scene scene, Archive& saved);

  Stress stress_at(ElementIndex e, Point start) const override;
  /// Solves where the scene has not been solved yet: its loads stay the same. Fails where a body can still move, with
  /// the motion, and where the forces between faces of cracks do not settle. Throws InputError where a load has no
  /// finite value.
  std::variant<StepReport, StepFailure> advance() override;
  std::optional<ForceBalance> forces() const override;
  /// Of faces of cracks.
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

  std::optional<ContinuumSolution> solution_;  ///< none before the first step
};

}  // namespace keyblock
