// Computes the motion of the bodies in one step without contact, and their response to forces.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// Free motion of all groups. Groups with linear equations are known at once, others are linearised about an estimate
/// of the increments. Δq = increments + A⁻¹ Gᵀ λ (smooth_solve.hpp). Keeps references to the scene and the start.
class FreeMotion {
 public:
  FreeMotion(const StandardScene& scene, const Motion& start, const UnknownsTable& loads, const StepRule& rule,
             double dt);

  /// Returns true if one iteration finds the solution.
  bool is_linear() const { return estimated_.empty(); }

  /// Computes A⁻¹ about an estimate. Returns false if the factorisation of a body fails: one that buckles or turns
  /// inside out may succeed in a shorter step.
  bool linearise(const UnknownsTable& estimate);
  /// Computes the free increments about an estimate, with the previous A⁻¹.
  void evaluate(const UnknownsTable& estimate);

  const UnknownsTable& increments() const { return step_.increments; }
  /// Returns the part of the end velocities that does not depend on the increments.
  const UnknownsTable& known_velocity() const { return step_.known_velocity; }
  const Flexibility& flexibility() const { return step_.flexibility; }
  Flexibility take_flexibility() && { return std::move(step_.flexibility); }
  /// Returns the flexibility by which forces are judged if it differs; otherwise empty.
  const Flexibility& judging() const { return step_.judging; }
  bool has_judging() const { return !step_.judging.blocks.empty(); }

  /// Returns the factor of the increments in the end velocity.
  double rate() const { return rule_.end_velocity.increment; }
  /// Returns the increments of a motion that continues, zero in statics. DDA blocks continue with the last
  /// acceleration, because their contact forces change little from step to step. Other bodies, and rules without
  /// acceleration, continue with the velocity.
  UnknownsTable going_on() const;
  bool goes_on_with_acceleration() const { return is_linear() && rule_.end_acceleration.increment != 0; }
  /// Returns the increments of a motion that continues with its velocity.
  UnknownsTable steady() const;
  /// Returns the end of the step. `is_found`: the increments solve the equations.
  BodiesMotion end(const UnknownsTable& increments, bool is_found) const;
  /// Returns true if some rock is elastoplastic.
  bool has_kinks() const { return has_kinks_; }

  /// Returns the greatest difference, relative to block size; rotation and strain are relative already.
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
