// What a run steps through: a model, the choices by which it moves, and the scene that follows it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/scene/scene_map.hpp"
#include "problem/cover_plan.hpp"
#include "settings/settings.hpp"

namespace keyblock {

struct SceneChange;
struct CrackGrowth;

/// When a scene gives way to the next, or the run ends.
struct SceneEnd {
  std::string name;                   ///< of the stage that the scene is
  int steps = 0;                      ///< at most; 0: all that the settings ask for
  std::optional<double> equilibrium;  ///< earlier where forces are balanced to this share of the largest load
};

/// What whoever made a scene worked out of its model and settings on the way; floors above know what it is.
struct Groundwork {
  virtual ~Groundwork() = default;
};

struct Scene {
  Model model;
  Settings settings;
  SceneEnd end = {};
  std::shared_ptr<const SceneChange> next = {};  ///< none of the last
  /// Bodies on covers at rest that do not feel each other, nor do the sides of their joints, but for faces of cracks
  /// whose tips have functions: each step is one linear solution, or, where rock may yield, goes on from the one
  /// before.
  bool is_untouched = false;
  /// Of a load step of such rock that may yield: how often it is halved before no equilibrium is said to be there.
  int load_cuts = 6;
  std::shared_ptr<const CrackGrowth> growth = {};  ///< of cracks during the run; none: they stay
  /// None, or of another model or other settings: steppers work it out, with the same result to the bit.
  std::shared_ptr<const Groundwork> groundwork = {};
};

/// How the cracks of a scene go on, and the same scene with other cracks.
struct CrackGrowth {
  GrowthPlan plan;
  std::vector<CrackPlan> cracks;
  /// With other cracks, its mesh refined at more points. Throws InputError as `prepare`.
  std::function<Scene(const std::vector<CrackPlan>&, const std::vector<RefinedPoint>&)> remade;
  double tip_side = 0;  ///< of triangles at tips
};

/// A scene, and what it was before.
struct SceneChange {
  Scene scene;
  SceneMap map;
};

/// Whether a material of its bodies on covers has a strength.
bool may_yield(const Scene& scene);

/// The scene and all that follow it, in order.
std::vector<const Scene*> scenes_of(const Scene& first);

}  // namespace keyblock
