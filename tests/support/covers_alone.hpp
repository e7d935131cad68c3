// Bodies on covers that nothing touches, moved by the step of the program and brought to rest by its Newton's method.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>

#include "model/continuum.hpp"
#include "model/setup/from_manifold.hpp"
#include "step/groups/cover_group.hpp"
#include "step/rest/share_control.hpp"
#include "step/time/smooth_solve.hpp"

namespace keyblock::support {

class CoversAlone {
 public:
  /// `stiffness_damping`: of all bodies, time.
  explicit CoversAlone(const Continuum& continuum, double stiffness_damping = 0) {
    Analysis analysis;
    analysis.block_materials = continuum.materials;
    analysis.joint_materials.emplace_back();
    Model model = model_from_manifold(continuum.manifold, {}, analysis);
    model.continuum = std::make_shared<Continuum>(continuum);
    Settings settings;
    if (stiffness_damping > 0) settings.stiffness_damping = std::optional(stiffness_damping);
    scene_ = std::make_unique<StandardScene>(standard_scene(std::move(model), std::move(settings)));
    start_ = start_motion(*scene_);
    for (const auto& group : scene_->groups)
      if (const auto* covers = dynamic_cast<const CoverGroup*>(group.get())) covers_ = &covers->bodies();
    if (!covers_) throw std::logic_error("there are no bodies on covers");
  }

  const CoverScene& covers() const { return *covers_; }
  CoverEquations& equations() const { return covers_->equations(); }

  /// Undeformed, at rest.
  CoverMotion rest() const {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(start_.q.shared.size());
    return {zero, zero, zero, start_.points.covers};
  }

  struct Step {
    CoverMotion end;
    bool is_solved = false;
    int rounds = 0;  ///< of Newton's method
  };
  /// From `from` under `load`, all forces on the unknowns besides those of rock, inertia and supports.
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
  const CoverScene* covers_ = nullptr;
};

/// The states at rest of bodies whose loads grow from none.
class RestUnderLoads {
 public:
  explicit RestUnderLoads(const Continuum& continuum)
      : bodies_(continuum), control_(bodies_), now_(bodies_.at_start()) {
    bodies_.begin(now_, nullptr);
  }

  /// At a share of the loads, from the last; none: no state was found.
  std::optional<Eigen::VectorXd> at(double share) {
    NewtonRounds rounds;
    std::optional<LoadedState> found = control_.solve(now_, now_.d, share, rounds);
    if (!found) return std::nullopt;
    now_ = std::move(*found);
    return now_.d;
  }

 private:
  LoadedBodies bodies_;
  ShareControl control_;
  LoadedState now_;
};

}  // namespace keyblock::support
