// Runs a scene under a profile and counts how its steps were solved.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "run/prepare.hpp"
#include "tests/validate/random_scenes.hpp"

namespace keyblock {

/// How a run ended. `refused`: the profile does not support a feature of the scene; `failed`: a step could not be made;
/// `crashed`: an exception that is no message for a user.
enum class End { finished, refused, failed, crashed };

/// Results of one run.
struct SceneRun {
  std::string scene;
  std::string profile;
  End end = End::finished;
  std::string reason;  ///< reason for a refusal or a failure
  int blocks = 0;
  double time_step = 0;
  int asked = 0;                  ///< steps
  int made = 0;                   ///< steps
  int plain = 0;                  ///< made at the requested size, without a redone attempt or a fall-back
  int with_fallback = 0;          ///< made at the requested size without a redone attempt, by the fall-back
  int cut = 0;                    ///< redone, made in parts, or smaller than requested
  int cut_here = 0;               ///< of these, redone or made in parts at this very step
  int unsettled = 0;              ///< accepted with contacts that still opened or closed
  int passes = 0;                 ///< linear solves of all steps
  std::vector<double> residuals;  ///< one per step
  double seconds = 0;             ///< of processor time
  double energy_excess = 0;       ///< MotionWatch, as are the next five
  double energy_gain = 0;
  double energy_ratio = 0;
  double rise = 0;
  double area_change = 0;
  double false_area_change = 0;
  double overlap = 0;
  bool all_finite = true;

  int converged() const { return plain + with_fallback; }
};

/// Overrides for both profiles: they keep the time step of the scene.
std::vector<Override> constant_step();

SceneRun run_scene(const RandomScene& scene, const std::string& profile, const std::vector<Override>& overrides);

/// Runs scenes of the seeds first … first + count - 1 under both profiles, legacy before standard, in the order of the
/// seeds for any number of threads. `steps` of each; 0: as drawn.
std::vector<SceneRun> run_scenes(std::uint64_t first, int count, int threads, int steps = 0);

}  // namespace keyblock
