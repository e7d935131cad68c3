// Holds a scene of a run: a model, its settings, and the scene that follows it.
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

/// Conditions under which a scene gives way to the next, or the run ends.
struct SceneEnd {
  std::string name;                   ///< of the stage that the scene is
  int steps = 0;                      ///< at most; 0: all steps of the settings
  std::optional<double> equilibrium;  ///< earlier if forces balance to this share of the largest load
};

/// Data computed while the scene was built, kept so that the stepper need not repeat the work. Only higher layers know
/// its type.
struct Groundwork {
  virtual ~Groundwork() = default;
};

struct Scene {
  Model model;
  Settings settings;
  SceneEnd end = {};
  std::shared_ptr<const SceneChange> next = {};  ///< null for the last scene
  /// True for static NMM bodies without contact, except at faces of cracks whose tips have functions. Each step is then
  /// one linear solve, or, for elastoplastic rock, continues from the step before.
  bool is_untouched = false;
  /// Number of times that a load step of elastoplastic rock is halved before the search for equilibrium fails.
  int load_cuts = 6;
  std::shared_ptr<const CrackGrowth> growth = {};  ///< of cracks during the run; null: they do not grow
  /// Null, or of another model or other settings: steppers then compute it, with the same result to the bit.
  std::shared_ptr<const Groundwork> groundwork = {};
};

/// Rule by which the cracks of a scene propagate, and a function that rebuilds the scene with other cracks.
struct CrackGrowth {
  GrowthPlan plan;
  std::vector<CrackPlan> cracks;
  /// Rebuilds the scene with other cracks and its mesh refined at more points. Throws InputError as `prepare` does.
  std::function<Scene(const std::vector<CrackPlan>&, const std::vector<RefinedPoint>&)> remade;
  double tip_side = 0;  ///< of triangles at tips
};

/// A scene, and the map to the scene before it.
struct SceneChange {
  Scene scene;
  SceneMap map;
};

/// Returns the time from which loads, driven points and edges, and accelerations stay the same; 0: they never change.
double last_change_of_loads(const Scene& scene);

/// Returns the times of the rows of all tables of loads and accelerations, sorted. Between them loads are linear in
/// time, unless a formula gives them.
std::vector<double> bends_of_loads(const Model& model, const Settings& settings);

/// Returns true if a material of its NMM bodies has a strength.
bool may_yield(const Scene& scene);

/// Returns the scene and all that follow it, in order.
std::vector<const Scene*> scenes_of(const Scene& first);

}  // namespace keyblock
