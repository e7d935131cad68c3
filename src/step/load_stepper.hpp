// Makes load steps of elastoplastic NMM bodies without contact. Each step continues from the equilibrium of the last.
// Theory: docs/theory/07-initial-state-and-statics.md and docs/theory/09-plasticity.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "step/bodies/loaded_bodies.hpp"
#include "step/rest/arc_length.hpp"
#include "step/rest/share_control.hpp"
#include "step/static_stepper.hpp"

namespace keyblock {

/// Raises the loads of a scene in equal increments, up to their full size in its last step. If an increment finds no
/// equilibrium, it is halved, down to a smallest part. If that part finds none either, the run ends. The end is a limit
/// load if larger displacements carry no more load, and unknown otherwise. Under `load_control = arc_length` a step
/// follows the path of equilibria, and loads may fall. Its length is `path_step` times the displacement of elastic rock
/// under an equal increment. The scene ends at its full loads, even if steps remain.
class LoadStepper : public StaticStepper {
 public:
  explicit LoadStepper(Scene scene);
  /// Restores the stepper from a checkpoint of the same scene. Throws InputError.
  LoadStepper(Scene scene, Archive& saved);

  Stress stress_at(ElementIndex e, Point start) const override;
  std::optional<PlasticState> plastic_at(ElementIndex e, Point start) const override;
  std::optional<PlasticTotals> plastic_totals() const override;
  std::vector<double> driven() const override { return bodies_->driven(share_); }
  std::optional<double> load_share() const override { return path_ ? std::optional(share_) : std::nullopt; }
  bool is_done() const override { return path_ && share_ >= 1; }
  std::optional<State> attempted() const override { return attempted_; }
  std::variant<StepReport, StepFailure> advance() override;
  std::optional<ForceBalance> forces() const override { return bodies_->forces(now_.d, share_); }
  std::optional<CoverDisplacement> on_covers() const override { return CoverDisplacement{bodies_->basis(), now_.d}; }
  std::unique_ptr<SceneStepper> in_next(const SceneChange& change) const override;
  bool is_at_rest(double) const override { return share_ >= 1; }

 private:
  /// Effort and results of the parts of one step.
  struct Work {
    int rounds = 0;
    int cuts = 0;
    RoundsEnd cut_by = RoundsEnd::open;  ///< reason of the last cut
    int parts = 0;                       ///< parts that found an equilibrium
    std::vector<double> residuals = {};  ///< residuals of the iterations of the last such part
    double plastic = 0;
  };

  /// Transfers the state of the bodies to the next scene, which uses the same mesh.
  LoadedState carried(const LoadedBodies& next, const SceneChange& change) const;
  int steps_of_scene() const;
  std::optional<Finding> advance_to(double share, Work& work);
  std::optional<Finding> advance_along(Work& work);
  static Facts effort_of(const Work& work);
  void accept(PathPoint found, Work& work);
  /// Stores the end point of the last search, which found no equilibrium, in `attempted_`.
  void keep_attempt(const Eigen::VectorXd& d);
  Point place_of(ElementIndex e, Point start) const override;
  double rotation_of(ElementIndex e, Point start) const override;
  void describe(Archive& archive) override;

  std::unique_ptr<LoadedBodies> bodies_;
  ShareControl by_share_;
  std::optional<ArcLength> path_;  ///< only under arc-length control
  LoadedState now_;
  Eigen::VectorXd
      speed_;         ///< displacement per load fraction in the last part of a step; serves as guess for the next part
  double share_ = 0;  ///< load fraction of the scene
  // State of arc-length control:
  Eigen::VectorXd way_;             ///< change of `now_.d` in the last step; zero before the first
  double share_change_ = 0;         ///< change of the load fraction in the last step
  double length_ = 0;               ///< arc length of an uncut step; 0: not chosen yet
  double part_ = 0;                 ///< arc length of the next step
  double plastic_work_ = 0;         ///< since the start, by the stress at the end of each part of a step
  int first_step_ = 0;              ///< last step before the scene
  std::optional<State> attempted_;  ///< end of a failed step
};

}  // namespace keyblock
