// Runs a case as its folder defines it, and picks the values.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/cases/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <variant>

#include "api/plan.hpp"
#include "model/continuum.hpp"
#include "study/strength/strength_plan.hpp"

namespace keyblock::study {
namespace {

/// Contents of the folder, read once for all its runs.
struct Loaded : OpenCase {
  std::string label;  ///< for tables
  std::string table;  ///< path of expected.csv
  std::vector<ExpectedValue> expected;
};

Loaded load(const CaseFolder& folder) {
  const std::string table = (folder.folder / "expected.csv").string();
  return {opened(asked_case({{folder.folder.string()}, {}, {}, {}})), folder.name, table, read_expected(table)};
}

int first_block(const std::vector<ComparedValue>& values) {
  const auto followed =
      std::ranges::find_if(values, [](const ComparedValue& v) { return owner_of(v.quantity) == Owner::block; });
  return followed == values.end() ? 1 : *followed->block;
}

ConfiguredCase configured_as_in_file(const Loaded& loaded, const std::string& profile,
                                     const std::vector<Override>& more) {
  try {
    return configured_under(profile, loaded, loaded.input.problem, more);
  } catch (const std::invalid_argument& error) {
    throw InputError({loaded.file.path, 0, 0}, error.what());
  }
}

// An invalid setting is an error of the case file. A scene that the profile refuses is a result: the reason.
std::variant<Prepared, std::string> prepared_or_refused(const Loaded& loaded, const std::string& profile,
                                                        const std::vector<Override>& more) {
  const ConfiguredCase made = configured_as_in_file(loaded, profile, more);
  try {
    return prepared_case(made);
  } catch (const std::invalid_argument& error) {
    throw InputError({loaded.file.path, 0, 0}, error.what());
  } catch (const InputError& error) {
    return error.what();
  }
}

ComparedCase run_and_pick(const Scene& scene, ComparedCase compared) {
  compared.followed_block = first_block(compared.values);
  RunSoFar so_far;
  Observer observer;
  observer.on_step = [&](const StepReport& report) { so_far.add(report); };
  observer.on_frame = [&](const Frame& frame) {
    pick(compared.values, so_far, frame, kSameInstant * scene.settings.time_step);
    const ElementFrame* followed = element_of(frame, compared.followed_block - 1);
    if (followed == nullptr) return;  // excavated
    compared.times.push_back(frame.time);
    compared.displacements.push_back(length(followed->displacement));
  };
  compared.outcome = run(scene, 1, observer);
  compared.start = so_far.start();
  compared.end = so_far.now();
  return compared;
}

// Takes the last stable state, at the instant 0, because a factor belongs to no instant.
ComparedCase reduced_and_picked(const Loaded& loaded, ComparedCase compared, const std::vector<Override>& more) {
  const StrengthPlan plan =
      strength_plan(loaded, loaded.input, {}, configured_under(compared.profile, loaded, loaded.input.problem, more));
  compared.warnings = joined(loaded.input.warnings, plan.trials.prepared().warnings);
  const auto failed = [&](std::string reason) {
    compared.outcome.end = RunEnd::failed;
    compared.outcome.reason = std::move(reason);
    return compared;
  };
  if (!plan.refusal.empty()) return failed(plan.refusal);
  PlannedSearch search;
  search.seeks_knee = false;
  FactorOfSafety found = factor_of_safety(plan, search);
  if (found.end != SearchEnd::bracketed)
    return failed(fmt::format("no bracket of the factor of safety: {}", name_of(found.end)));
  Frame frame = std::move(found.standing->frame);
  frame.time = 0;
  RunSoFar so_far;
  so_far.add_factor_of_safety(found.bracket.middle());
  pick(compared.values, so_far, frame, kSameInstant);
  compared.start = frame;
  compared.end = std::move(frame);
  return compared;
}

ComparedCase compared_by_reduction(const Loaded& loaded, ComparedCase compared, const std::vector<Override>& more) {
  try {
    return reduced_and_picked(loaded, compared, more);
  } catch (const std::invalid_argument& error) {
    throw InputError({loaded.file.path, 0, 0}, error.what());
  } catch (const InputError& error) {
    compared.not_run = error.what();
    return compared;
  }
}

ComparedCase compared_with(const Loaded& loaded, ComparedCase compared, const std::vector<Override>& more) {
  compared.name = loaded.label;
  if (loaded.file.reduction) return compared_by_reduction(loaded, std::move(compared), more);
  const auto made = prepared_or_refused(loaded, compared.profile, more);
  if (const auto* why = std::get_if<std::string>(&made)) {
    compared.not_run = *why;
    return compared;
  }
  const Prepared& prepared = std::get<Prepared>(made);
  compared.warnings = joined(loaded.input.warnings, prepared.warnings);
  const Model& model = prepared.scene.model;
  require_numbers(compared.values, model, loaded.table);
  return run_and_pick(prepared.scene, std::move(compared));
}

ComparedCase plain_run(const Loaded& loaded, const std::string& profile) {
  ComparedCase compared;
  compared.name = loaded.label;
  compared.profile = profile;
  compared.values = values_to_find(loaded.expected, profile);
  compared.not_run = why_not_run(loaded, profile);
  if (compared.not_run.empty()) return compared_with(loaded, std::move(compared), {});
  for (ComparedValue& v : compared.values) v.is_judged = false;
  return compared;
}

ComparedCase variant_run(const Loaded& loaded, const Variant& variant) {
  ComparedCase compared;
  compared.profile = variant.profile;
  compared.variant = variant.name;
  compared.values = values_to_find(loaded.expected, variant.profile);
  for (ComparedValue& v : compared.values) {
    if (!variant.tolerance) continue;
    v.tolerance = *variant.tolerance;
    v.tolerance_reason = variant.reason;
    v.listed_miss.clear();
  }
  try {
    return compared_with(loaded, compared, variant.set);
  } catch (const InputError& error) {  // the other runs of the case continue
    compared.not_run = error.what();
    return compared;
  }
}

}  // namespace

bool ComparedCase::holds() const {
  if (std::ranges::none_of(values, &ComparedValue::is_judged)) return true;
  return not_run.empty() && outcome.end == RunEnd::finished && std::ranges::none_of(values, &ComparedValue::is_missed);
}

bool CaseComparison::holds() const {
  return std::ranges::all_of(plain, &ComparedCase::holds) && std::ranges::all_of(variants, &ComparedCase::holds);
}

CaseComparison compare_in(const CaseFolder& folder, const std::vector<std::string>& profiles) {
  const Loaded loaded = load(folder);
  CaseComparison comparison{loaded.label, loaded.file.about, {}, {}};
  for (const std::string& profile : profiles) comparison.plain.push_back(plain_run(loaded, profile));
  for (const Variant& variant : loaded.file.variants)
    if (std::ranges::find(profiles, variant.profile) != profiles.end())
      comparison.variants.push_back(variant_run(loaded, variant));
  return comparison;
}

}  // namespace keyblock::study
