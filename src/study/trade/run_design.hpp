// Selects the runs of a case worth comparing: choices that affect cost and accuracy, one at a time and in useful pairs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "study/trade/measured_run.hpp"

namespace keyblock::study {

/// One option of a choice.
struct Level {
  std::string name;  ///< "step /2"
  std::vector<Override> set;
  double refinement = 1;                    ///< of the step or the mesh: 2 is twice as fine; 1 for other choices
  std::optional<std::string> coarser = {};  ///< the level that this one refines; the empty name is the case's own
};

/// Choice, with its levels besides the case's own.
struct Axis {
  std::string name;
  std::vector<Level> levels;
};

/// Returns the choices of a case under a profile: basis, enforcement, penalty, step, tolerance and integrator for DDA
/// blocks, functions and mesh for NMM bodies. Throws InputError if the case cannot be run, std::invalid_argument for
/// invalid settings.
std::vector<Axis> axes_of(const StudyCase& chosen, const std::string& profile);

/// Returns the case in the profile itself, in all other profiles, with every level of every axis alone, and with pairs
/// of levels. `vary`: names of the axes; empty: all. Throws std::invalid_argument for an unknown name.
std::vector<RunPlan> usual_design(const StudyCase& chosen, const std::string& profile,
                                  const std::vector<std::string>& vary = {});

/// Returns the profiles, and all combinations of levels, at most `most` runs.
std::vector<RunPlan> full_design(const StudyCase& chosen, const std::string& profile, std::size_t most,
                                 const std::vector<std::string>& vary = {});

/// Returns the case in the profile as it is, with half, and with a quarter of the step; in linear statics, of the mesh
/// side. Coarsest first, with the names that the designs have for them. `finest`: a power of two, 4 or more; then the
/// last three of the halvings down to that part.
std::vector<RunPlan> refinements(const StudyCase& chosen, const std::string& profile, int finest);

/// Returns `plan`, one of the designs under `profile`, with its step divided by `parts`, a power of two. The side of
/// the mesh, or the tolerance of steps controlled by error, may replace the step. Empty if nothing is left to divide.
/// Throws as `axes_of`.
std::optional<RunPlan> refined(const StudyCase& chosen, const std::string& profile, const RunPlan& plan, int parts);

/// Returns every penalty with every step, as factors of the case's own, steps fastest. Contact uses springs whose
/// stiffness stays. Throws as `axes_of`, and std::invalid_argument for a case that has neither.
std::vector<RunPlan> penalty_step_map(const StudyCase& chosen, const std::string& profile,
                                      const std::vector<double>& penalties, const std::vector<double>& steps);

}  // namespace keyblock::study
