// Which runs of a case are worth comparing: the choices that cost and accuracy hang on, one at a time and in useful
// pairs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "study/trade/measured_run.hpp"

namespace keyblock::study {

/// One way to make a choice.
struct Level {
  std::string name;  ///< "step /2"
  std::vector<Override> set;
  double refinement = 1;                    ///< of the step or the mesh: 2 is twice as fine; 1 for other choices
  std::optional<std::string> coarser = {};  ///< the level that this one refines, the empty name for the case's own
};

/// A choice: the levels beside the case's own.
struct Axis {
  std::string name;
  std::vector<Level> levels;
};

/// The choices that a case has under a profile: basis, enforcement, penalty, step, tolerance, integrator for blocks,
/// functions and mesh on covers. Throws InputError where the case cannot be run, std::invalid_argument for settings
/// that are none.
std::vector<Axis> axes_of(const StudyCase& chosen, const std::string& profile);

/// The case in the profile itself, in all other profiles, with every level of every axis alone, and with pairs of
/// levels. `vary`: the names of the axes; all where it is empty. Throws std::invalid_argument for a name that is none
/// here.
std::vector<RunPlan> usual_design(const StudyCase& chosen, const std::string& profile,
                                  const std::vector<std::string>& vary = {});

/// The profiles, and all combinations of levels, at most `most` runs.
std::vector<RunPlan> full_design(const StudyCase& chosen, const std::string& profile, std::size_t most,
                                 const std::vector<std::string>& vary = {});

/// The case in the profile as it is, with half and with a quarter of the step, or of the side of the mesh where the
/// case is of linear statics; coarsest first, with the names that the designs have for them. `finest`: a power of two,
/// 4 or more; then the last three of the halvings down to that part.
std::vector<RunPlan> refinements(const StudyCase& chosen, const std::string& profile, int finest);

/// `plan`, one of the designs under `profile`, with steps (or sides of the mesh, or where steps go by their error its
/// tolerance) of a part of its own; nothing where there is nothing left to divide. `parts`: a power of two. Throws as
/// `axes_of`.
std::optional<RunPlan> refined(const StudyCase& chosen, const std::string& profile, const RunPlan& plan, int parts);

/// Every penalty with every step, factors of the case's own, steps fastest. Contact is by springs, whose stiffness
/// stays. Throws as `axes_of`, and std::invalid_argument for a case that has neither.
std::vector<RunPlan> penalty_step_map(const StudyCase& chosen, const std::string& profile,
                                      const std::vector<double>& penalties, const std::vector<double>& steps);

}  // namespace keyblock::study
