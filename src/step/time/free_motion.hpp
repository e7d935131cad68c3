// The bodies of one step without contact: what they do under their loads, and how they answer forces.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// Of all groups: those whose equations are linear are known at once, others are linearised about an estimate of the
/// increments. Δq = increments + A⁻¹ Gᵀ λ (smooth_solve.hpp). Views the scene and the start.
class FreeMotion {
 public:
  FreeMotion(const StandardScene& scene, const Motion& start, const UnknownsTable& loads, const StepRule& rule,
             double dt);

  /// Whether one round finds all.
  bool is_linear() const { return estimated_.empty(); }

  /// A⁻¹ about an estimate. False where a body has no factor: one that buckles, or turns inside out, may have one in a
  /// shorter step.
  bool linearise(const UnknownsTable& estimate);
  /// The free increments about an estimate, with the A⁻¹ of before.
  void evaluate(const UnknownsTable& estimate);

  const UnknownsTable& increments() const { return step_.increments; }
  /// What the increments leave of the velocities at the end.
  const UnknownsTable& known_velocity() const { return step_.known_velocity; }
  const Flexibility& flexibility() const { return step_.flexibility; }
  Flexibility take_flexibility() && { return std::move(step_.flexibility); }
  /// By which forces are judged, where that is another; else empty.
  const Flexibility& judging() const { return step_.judging; }
  bool has_judging() const { return !step_.judging.blocks.empty(); }

  /// Share of the increments in the velocity at the end, over the known one.
  double rate() const { return rule_.end_velocity.increment; }
  /// Increments of a motion that goes on as it is, at rest none: with the acceleration of the step before where bodies
  /// are blocks, whose contact forces change little from step to step, else with the velocity, as where a rule has no
  /// acceleration.
  UnknownsTable going_on() const;
  bool goes_on_with_acceleration() const { return is_linear() && rule_.end_acceleration.increment != 0; }
  /// Those of a motion that goes on with its velocity.
  UnknownsTable steady() const;
  /// The end of the step. `is_found`: the increments solve the equations.
  BodiesMotion end(const UnknownsTable& increments, bool is_found) const;
  /// Whether rock may yield.
  bool has_kinks() const { return has_kinks_; }

  /// Relative to block size; rotation and strain are relative as they are.
  double greatest_change(const UnknownsTable& a, const UnknownsTable& b) const;
  double size() const { return size_; }  ///< of the largest moving body

 private:
  const StandardScene& scene_;
  const Motion& start_;
  StepRule rule_;
  double size_ = 0;
  bool has_kinks_ = false;
  FreeStep step_;
  std::vector<std::unique_ptr<EstimatedStep>> estimated_;
};

}  // namespace keyblock
