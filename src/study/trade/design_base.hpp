// Declares the case from which levels of a design are made, and settings that make its step, mesh or springs finer.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "problem/cover_plan.hpp"
#include "settings/settings.hpp"
#include "settings/settings_table.hpp"
#include "study/trade/measured_run.hpp"

namespace keyblock::study {

/// Case as it is, from which the levels of a design are made.
struct DesignBase {
  bool is_untouched = false;    ///< as in Scene
  bool has_plan = false;        ///< NMM bodies, by a case file
  bool has_cover_file = false;  ///< or by a cover file
  bool has_blocks = true;
  Settings settings;
  CoverPlan plan;
  std::size_t blocks = 0;
  std::vector<double> times;  ///< of expected values
  double step_factor = 1;     ///< by which the profile lengthens the given step

  bool is_standard() const { return settings.dynamics == Dynamics::standard; }
};

/// Prepares the case under a profile and more settings. Throws as `axes_of`.
DesignBase base_of(const StudyCase& chosen, const std::string& profile, const std::vector<Override>& more = {});

/// Rounds the number of steps so that the run ends at the same time and expected times stay ends of steps. Empty if
/// that leaves the case's own step.
std::vector<Override> step_overrides(const DesignBase& base, double factor);

/// Returns the error, side or number of rows of a mesh, finer by a factor below 1. Empty if nothing changes.
std::vector<Override> mesh_overrides(const MeshPlan& mesh, double factor);

/// Returns "mesh error" or "side".
const char* word_of(const MeshPlan& mesh);

std::vector<Override> penalty_overrides(const DesignBase& base, double factor);

/// Returns "step x2", "step /4".
std::string factor_name(const char* of, double factor);

}  // namespace keyblock::study
