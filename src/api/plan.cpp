// Performs the steps of planning in order: profile, settings, files and mesh, scene, look ahead.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "api/plan.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "api/named_files.hpp"
#include "base/error.hpp"
#include "run/cover_settings.hpp"
#include "run/follow/history_option.hpp"
#include "run/look_ahead.hpp"
#include "settings/profile.hpp"

namespace keyblock {

namespace {

// Throws InputError that names `case.json` if a setting of that file is impossible.
void require_those_of_file(const ConfiguredCase& made, Problem problem) {
  if (made.of_file.empty()) return;
  try {
    settings_of(problem, made.profile.name, set_plan(problem, made.of_file));
  } catch (const std::invalid_argument& error) {
    throw InputError({made.file, 0, 0}, error.what());
  }
}

ConfiguredCase with_settings(ChosenProfile profile, const AskedCase& asked, const Problem& problem,
                             const std::vector<Override>& more) {
  ConfiguredCase made{std::move(profile), {}, {}, {}, asked.file.path, {}};
  made.asked = asked.overrides(made.profile.name);
  made.of_file = asked.file.overrides(made.profile.name);
  made.asked.insert(made.asked.end(), more.begin(), more.end());
  made.problem = with_named_files(problem, made.asked);
  try {
    made.overrides = set_plan(made.problem, made.asked);
  } catch (const std::invalid_argument&) {
    require_those_of_file(made, problem);
    throw;
  }
  return made;
}

}  // namespace

std::vector<std::string> named_files(const ConfiguredCase& made) {
  std::vector<std::string> files = named_files(made.problem.choices.settings);
  for (std::string& file : named_files(made.asked)) files.push_back(std::move(file));
  return files;
}

std::string why_not_run(const AskedCase& asked, const std::string& profile) {
  const auto found = asked.file.not_run.find(rules_of(profile));
  return found == asked.file.not_run.end() ? std::string() : found->second;
}

ChosenProfile profile_for(const AskedCase& asked, const Problem& problem, OldFiles old_files) {
  ChosenProfile chosen = chosen_profile(problem, asked.profile, asked.common);
  const bool is_open = asked.profile.empty() && problem.choices.profile.empty() && chosen.name == "legacy";
  if (const std::string why = why_not_run(asked, "legacy"); is_open && !why.empty())
    chosen = {"standard", fmt::format("{}, under legacy: {}", asked.file.path, why)};
  else if (is_open && old_files == OldFiles::standard)
    chosen = {"standard", "the rules of Shi's programs cannot compute this"};
  if (const std::string why = why_not_run(asked, chosen.name); !why.empty())
    throw UsageError(fmt::format("{}, under profile {}: {}", asked.file.path, chosen.name, why));
  return chosen;
}

ConfiguredCase configured(const AskedCase& asked, const Problem& problem, OldFiles old_files) {
  return with_settings(profile_for(asked, problem, old_files), asked, problem, {});
}

ConfiguredCase configured_under(const std::string& profile, const AskedCase& asked, const Problem& problem,
                                const std::vector<Override>& more) {
  return with_settings({profile, {}}, asked, problem, more);
}

Prepared prepared_case(const ConfiguredCase& made) {
  try {
    return prepare(made.problem, made.profile.name, made.overrides);
  } catch (const std::invalid_argument&) {
    require_those_of_file(made, made.problem);
    throw;
  }
}

PlannedCase planned(const AskedCase& asked, const Problem& problem) {
  PlannedCase plan{configured(asked, problem), {}, {}};
  plan.problem = with_followed_points(std::move(plan.problem));
  plan.prepared = prepared_case(plan);
  plan.warnings = joined(plan.prepared.warnings, look_ahead(plan.problem, plan.prepared));
  return plan;
}

}  // namespace keyblock
