// Summarises many runs: shares of converged steps, by kind of scene and profile.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/validate/convergence.hpp"

namespace keyblock {

/// The runs of one kind of scene under one profile, summed.
struct Share {
  std::string kind;
  std::string profile;
  int scenes = 0;
  int refused = 0;
  int failed = 0;
  int crashed = 0;
  int silent = 0;  ///< ended early without a reason
  long asked = 0;  ///< steps of all scenes; those of a refused one count as not made
  long plain = 0;  ///< as SceneRun, as are the next three
  long with_fallback = 0;
  long cut = 0;
  long unsettled = 0;
  double passes = 0;  ///< a step, mean
  double median_residual = 0;
  double greatest_residual = 0;
  long above_goal = 0;     ///< steps whose residual is above 1e-6
  double energy_gain = 0;  ///< largest of all runs, as are the next four
  double energy_excess = 0;
  double rise = 0;
  double area_change = 0;
  double false_area_change = 0;
  double overlap = 0;
  double seconds = 0;  ///< of processor time

  double converged() const {
    return asked == 0 ? 1 : static_cast<double>(plain + with_fallback) / static_cast<double>(asked);
  }
  double by_newton() const { return asked == 0 ? 1 : static_cast<double>(plain) / static_cast<double>(asked); }
};

/// Returns one row for every kind ("stack", "slope", "all") and profile.
std::vector<Share> shares_of(const std::vector<SceneRun>& runs);

/// Columns as in Share.
std::string shares_csv(const std::vector<Share>& shares);

/// Writes the runs that ended early: scene, profile, blocks, step, steps made, end, reason.
std::string ended_csv(const std::vector<SceneRun>& runs);

/// Counts the runs that ended early, by profile, end and reason. Reasons are compared without their step and without
/// the names behind a semicolon.
std::string reasons_csv(const std::vector<SceneRun>& runs);

/// Writes one line per run: the addends of shares_csv, by scene.
std::string runs_csv(const std::vector<SceneRun>& runs);

/// Returns one sentence for each requirement that profile `standard` misses.
std::vector<std::string> misses_of_standard(const std::vector<Share>& shares);

}  // namespace keyblock
