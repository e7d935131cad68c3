// Load steps of bodies on covers that nothing touches and whose rock may yield: each goes on from the one before.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "step/bodies/loaded_bodies.hpp"
#include "step/rest/arc_length.hpp"
#include "step/rest/share_control.hpp"
#include "step/static_stepper.hpp"

namespace keyblock {

/// Loads of a scene grow in equal parts to their full size in its last step. A step whose part finds no equilibrium is
/// made in halves, quarters, …; where the least part finds none, the run ends: at a limit load, where larger
/// displacements carry no more, else before one is known. Under `load_control = arc_length` a step goes along the path
/// of equilibria instead, `path_step` times as far as an equal share would move elastic rock, and loads may fall; the
/// scene ends at its full loads, wherever steps lead before.
class LoadStepper : public StaticStepper {
 public:
  explicit LoadStepper(Scene scene);
  /// As it was saved, of the same scene. Throws InputError.
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
  /// What the parts of a step took.
  struct Work {
    int rounds = 0;
    int cuts = 0;
    RoundsEnd cut_by = RoundsEnd::open;  ///< the last
    int parts = 0;                       ///< of those that found an equilibrium
    std::vector<double> residuals = {};  ///< of the rounds of the last of them
    double plastic = 0;
  };

  /// The state of the bodies in the next scene, which stand on the same mesh.
  LoadedState carried(const LoadedBodies& next, const SceneChange& change) const;
  int steps_of_scene() const;
  std::optional<std::string> advance_to(double share, Work& work);
  std::optional<std::string> advance_along(Work& work);
  void accept(PathPoint found, Work& work);
  /// Puts where the last search for an equilibrium ended, without finding one.
  void keep_attempt(const Eigen::VectorXd& d);
  Point place_of(ElementIndex e, Point start) const override;
  double rotation_of(ElementIndex e, Point start) const override;
  void describe(Archive& archive) override;

  std::unique_ptr<LoadedBodies> bodies_;
  ShareControl by_share_;
  std::optional<ArcLength> path_;  ///< under control by arc length
  LoadedState now_;
  Eigen::VectorXd
      speed_;         ///< displacement per share of the loads in the last part of a step: the next is guessed by it
  double share_ = 0;  ///< of the scene's loads
  // Along the path of equilibria:
  Eigen::VectorXd way_;             ///< change of `now_.d` in the last step; zero before the first
  double share_change_ = 0;         ///< in it
  double length_ = 0;               ///< of a step that is not cut; 0: none was made
  double part_ = 0;                 ///< of the step to come
  double plastic_work_ = 0;         ///< since the start, by the stress at the end of each part of a step
  int first_step_ = 0;              ///< after which the scene began
  std::optional<State> attempted_;  ///< of a step that failed
};

}  // namespace keyblock
