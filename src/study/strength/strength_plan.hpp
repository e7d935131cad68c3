// Plans the search for the factor of safety of a case that was read, and makes it: for `fos`, comparisons, the library.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "api/plan.hpp"
#include "study/strength/factor_of_safety.hpp"

namespace keyblock::study {

/// Search that is ready for its first trial.
struct StrengthPlan {
  ReductionAsked reduction;  ///< completed: strength and width are set
  StrengthTrials trials;
  Warnings warnings = {};    ///< of reading, of the preparation, and of the checks before a run
  std::string refusal = {};  ///< reason why the case has no factor of safety; otherwise empty
  std::string help = {};     ///< remedy
};

/// Plans the search that `given`, then `case.json`, then the defaults request. The default profile is `standard`, also
/// for files of Shi's programs, because the search is static. A case is refused if nothing fixes its blocks, and
/// gravity acts, so that they fall at any factor, or no load at all. Throws UsageError for an impossible range, for an
/// exemption of `given` without effect, and for a profile that `case.json` does not run. Throws InputError for a case
/// that cannot be reduced; std::invalid_argument for an invalid setting.
StrengthPlan strength_plan(const AskedCase& asked, const formats::Case& input, const ReductionAsked& given);

/// Does the same for a case with another profile or other settings.
StrengthPlan strength_plan(const AskedCase& asked, const formats::Case& input, const ReductionAsked& given,
                           ConfiguredCase made);

/// Choices of a search beyond its plan. The plan sets `from`, `to` and `within`.
struct PlannedSearch : SearchOptions {
  bool seeks_mesh_error = false;                  ///< by a second search on a coarser mesh
  std::function<void()> on_coarser_mesh = [] {};  ///< before that search
};

/// Makes the search of a plan without refusal. Throws as the trials.
FactorOfSafety factor_of_safety(const StrengthPlan& plan, PlannedSearch search = {});

}  // namespace keyblock::study
