// Completes the request, checks it, prepares the trials, and looks ahead.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/strength/strength_plan.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "problem/checks/check.hpp"
#include "run/look_ahead.hpp"
#include "study/strength/mesh_error.hpp"

namespace keyblock::study {
namespace {

void require_range(const ReductionAsked& reduction) {
  const auto& [what, from, to, within, exempt] = reduction;
  if (from && to && !(*to > *from))
    throw UsageError(fmt::format("--to: expected more than --from {}, found {}", *from, *to));
  if (!from && to && !(*to > 1))
    throw UsageError(fmt::format("--to: expected more than 1 without --from, found {}", *to));
}

// Rejects exemptions of the caller without effect; a case file may exempt for any reduction.
void require_effect(const std::vector<std::string>& exempt, Reduced what) {
  for (const std::string& word : exempt) {
    const bool is_of_rock = word.starts_with("material:");
    if (is_of_rock ? what == Reduced::joints : what == Reduced::rock && word.starts_with("joint_material:"))
      throw UsageError(fmt::format(
          "--exempt {}: it has no effect, because only the strength of {} is reduced (--reduce)", word, name_of(what)));
  }
}

void refuse_free_blocks(StrengthPlan& plan) {
  const Problem& problem = plan.trials.problem();
  if (!fixes_nothing(problem)) return;
  plan.help = "add fixed points or fixed lines, such as the base and the sides of the slope";
  if (length(plan.trials.prepared().scene.settings.gravity) > 0) {
    plan.refusal = "nothing fixes the blocks, so that they fall at any strength and have no factor of safety";
  } else if (is_unloaded(problem)) {
    plan.refusal = "nothing fixes the blocks, and no load acts on them, so that they have no factor of safety";
    plan.help += ", and gravity or loads";
  }
}

StrengthPlan plan_of(ReductionAsked reduction, const formats::Case& input, ConfiguredCase made) {
  StrengthPlan plan{reduction, {std::move(made), *reduction.what, exempt_of(reduction.exempt)}};
  const Prepared& prepared = plan.trials.prepared();
  plan.warnings = joined(joined(input.warnings, prepared.warnings), look_ahead(input.problem, prepared));
  refuse_free_blocks(plan);
  return plan;
}

ReductionAsked completed_for(const AskedCase& asked, const ReductionAsked& given) {
  ReductionAsked reduction = completed(given, asked.file.reduction);
  require_range(reduction);
  require_effect(given.exempt, *reduction.what);
  return reduction;
}

}  // namespace

StrengthPlan strength_plan(const AskedCase& asked, const formats::Case& input, const ReductionAsked& given) {
  return plan_of(completed_for(asked, given), input, configured(asked, input.problem, OldFiles::standard));
}

StrengthPlan strength_plan(const AskedCase& asked, const formats::Case& input, const ReductionAsked& given,
                           ConfiguredCase made) {
  return plan_of(completed_for(asked, given), input, std::move(made));
}

FactorOfSafety factor_of_safety(const StrengthPlan& plan, PlannedSearch search) {
  search.from = plan.reduction.from;
  search.to = plan.reduction.to;
  search.within = *plan.reduction.within;
  FactorOfSafety found = factor_of_safety(plan.trials, static_cast<const SearchOptions&>(search));
  if (!search.seeks_mesh_error || found.end != SearchEnd::bracketed || !plan.trials.depends_on_mesh()) return found;
  search.on_coarser_mesh();
  found.mesh_error = mesh_error(plan.trials, found, search);
  found.notes.push_back(in_words(*found.mesh_error));
  return found;
}

}  // namespace keyblock::study
