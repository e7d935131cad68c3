// One step after the other.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "api/plan.hpp"

#include <fmt/format.h>

#include <utility>

#include "api/named_files.hpp"
#include "base/error.hpp"
#include "run/cover_settings.hpp"
#include "run/follow/history_option.hpp"
#include "run/look_ahead.hpp"
#include "settings/profile.hpp"

namespace keyblock {

namespace {

ConfiguredCase with_settings(ChosenProfile profile, std::vector<Override> asked, const Problem& problem) {
  ConfiguredCase made{std::move(profile), std::move(asked), {}, {}};
  made.problem = with_named_files(problem, made.asked);
  made.overrides = set_plan(made.problem, made.asked);
  return made;
}

}  // namespace

std::string why_not_run(const AskedCase& asked, const std::string& profile) {
  const auto found = asked.file.not_run.find(rules_of(profile));
  return found == asked.file.not_run.end() ? std::string() : found->second;
}

ChosenProfile profile_for(const AskedCase& asked, const Problem& problem, OldFiles old_files) {
  ChosenProfile chosen = chosen_profile(problem, asked.profile, asked.common);
  const bool is_open = asked.profile.empty() && problem.choices.profile.empty() && chosen.name == "legacy";
  if (is_open && old_files == OldFiles::standard)
    chosen = {"standard", "the rules of the old programs do not answer this"};
  else if (is_open && !why_not_run(asked, "legacy").empty())
    chosen = {"standard", fmt::format("{} says of legacy: {}", asked.file.path, why_not_run(asked, "legacy"))};
  if (const std::string why = why_not_run(asked, chosen.name); !why.empty())
    throw UsageError(fmt::format("{} says of profile {}: {}", asked.file.path, chosen.name, why));
  return chosen;
}

ConfiguredCase configured(const AskedCase& asked, const Problem& problem, OldFiles old_files) {
  ChosenProfile profile = profile_for(asked, problem, old_files);
  std::vector<Override> settings = asked.overrides(profile.name);
  return with_settings(std::move(profile), std::move(settings), problem);
}

ConfiguredCase configured_under(const std::string& profile, const AskedCase& asked, const Problem& problem,
                                const std::vector<Override>& more) {
  std::vector<Override> settings = asked.overrides(profile);
  settings.insert(settings.end(), more.begin(), more.end());
  return with_settings({profile, {}}, std::move(settings), problem);
}

Prepared prepared_case(const ConfiguredCase& made) {
  return prepare(made.problem, made.profile.name, made.overrides);
}

PlannedCase planned(const AskedCase& asked, const Problem& problem) {
  PlannedCase plan{configured(asked, problem), {}, {}};
  plan.problem = with_followed_points(std::move(plan.problem));
  plan.prepared = prepared_case(plan);
  plan.warnings = joined(plan.prepared.warnings, look_ahead(plan.problem, plan.prepared));
  return plan;
}

}  // namespace keyblock
