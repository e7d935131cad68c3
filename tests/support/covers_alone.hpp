// Moves NMM bodies without contact by the step of the program, and finds their static equilibrium.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "model/continuum.hpp"
#include "model/setup/from_manifold.hpp"
#include "step/groups/cover_group.hpp"
#include "step/standard_stepper.hpp"
#include "step/time/smooth_solve.hpp"

namespace keyblock::support {

inline Scene scene_of_covers(const Continuum& continuum) {
  Analysis analysis;
  analysis.block_materials = continuum.materials;
  analysis.joint_materials.emplace_back();
  Scene scene{model_from_manifold(continuum.manifold, {}, analysis), {}};
  scene.model.continuum = std::make_shared<Continuum>(continuum);
  return scene;
}

class CoversAlone {
 public:
  /// `stiffness_damping`: that of all bodies [time].
  explicit CoversAlone(const Continuum& continuum, double stiffness_damping = 0) {
    Scene scene = scene_of_covers(continuum);
    if (stiffness_damping > 0) scene.settings.stiffness_damping = std::optional(stiffness_damping);
    scene_ = std::make_unique<StandardScene>(standard_scene(std::move(scene.model), std::move(scene.settings)));
    start_ = start_motion(*scene_);
    for (const auto& group : scene_->groups)
      if (const auto* covers = dynamic_cast<const CoverGroup*>(group.get())) covers_ = covers;
    if (!covers_) throw std::logic_error("there are no bodies on covers");
  }

  const CoverScene& covers() const { return covers_->bodies(); }
  CoverEquations& equations() const { return covers_->equations(); }

  /// Returns the undeformed state, at rest.
  CoverMotion rest() const {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(start_.q.shared.size());
    return {zero, zero, zero, start_.points.covers};
  }

  struct Step {
    CoverMotion end;
    bool is_solved = false;
    int rounds = 0;  ///< of Newton's method
  };
  /// Makes a step from `from` under `load`: all forces on the unknowns except those of rock, inertia and supports.
  Step step(const CoverMotion& from, const Eigen::VectorXd& load, const StepRule& rule, double dt) const {
    Motion motion = start_;
    motion.q.shared = from.q;
    motion.v.shared = from.v;
    motion.a.shared = from.a;
    motion.points.covers = from.points;
    UnknownsTable loads = loads_at(*scene_, motion.q, 0);
    loads.shared = load;
    SmoothMotion made = smooth_solve(*scene_, motion, loads, {}, {}, 0, dt, rule);
    return {{made.q.shared, made.v.shared, made.a.shared, made.points.covers}, made.converged, made.rounds};
  }

 private:
  std::unique_ptr<StandardScene> scene_;
  Motion start_;
  const CoverGroup* covers_ = nullptr;
};

/// Returns the equilibrium of NMM bodies under as much of their loads as needed; empty if none was found.
inline std::optional<Eigen::VectorXd> at_rest_under_loads(const Continuum& continuum) {
  Scene scene = scene_of_covers(continuum);
  scene.settings.standard.motion = MotionRule::equilibrium;
  scene.settings.velocity_carry_over = 0;
  scene.settings.step_count = 1;
  scene.settings.time_step = scene.settings.allowed_displacement_ratio = 1;
  StandardStepper stepper(std::move(scene));
  if (!std::holds_alternative<StepReport>(stepper.advance())) return std::nullopt;
  return stepper.on_covers()->d;
}

}  // namespace keyblock::support
