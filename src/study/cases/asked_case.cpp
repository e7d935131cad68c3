// One step after the other: folder, settings file, profile, files and mesh that settings name.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/cases/asked_case.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "formats/registry.hpp"
#include "run/cover_settings.hpp"
#include "run/follow/history_option.hpp"
#include "run/look_ahead.hpp"
#include "run/settings_file.hpp"
#include "settings/profile.hpp"
#include "study/cases/named_files.hpp"

namespace keyblock::study {

namespace fs = std::filesystem;

namespace {

void put_files(AskedCase& asked, const std::vector<std::string>& paths) {
  if (paths.size() != 1 || !fs::is_directory(paths.front())) {
    asked.files = paths;
    if (!paths.empty()) asked.name = fs::path(paths.front()).stem().string();
    return;
  }
  const CaseFolder folder = the_case_in(paths.front());
  const fs::path whole = fs::absolute(folder.folder).lexically_normal();
  asked.name = (whole.parent_path().filename() / whole.filename()).string();  // cases share names as "coarse"
  asked.folder = folder.folder;
  asked.file = read_case_file(folder);
  asked.files = folder.inputs();
}

void put_settings_file(AskedCase& asked, const std::string& path) {
  if (path.empty()) return;
  const SettingsFile file = read_settings(path, formats::load(path).text);
  if (asked.profile.empty()) asked.profile = file.profile;
  for (const auto& [name, value] : file.settings)
    asked.common.emplace_back(name, from_folder(fs::path(path).parent_path(), name, value));
}

}  // namespace

std::vector<Override> AskedCase::overrides(const std::string& under) const {
  std::vector<Override> all = file.overrides(under);
  all.insert(all.end(), common.begin(), common.end());
  return all;
}

AskedCase asked_case(const CaseRequest& request) {
  AskedCase asked;
  asked.profile = request.profile;
  asked.choices = request.choices;
  put_files(asked, request.paths);
  put_settings_file(asked, request.settings_file);
  asked.common.insert(asked.common.end(), request.sets.begin(), request.sets.end());
  return asked;
}

ChosenProfile profile_for(const AskedCase& asked, const Problem& problem, OldFiles old_files) {
  ChosenProfile chosen = chosen_profile(problem, asked.profile, asked.common);
  const auto why_not = [&](const std::string& profile) {
    const auto found = asked.file.not_run.find(rules_of(profile));
    return found == asked.file.not_run.end() ? std::string() : found->second;
  };
  const bool is_open = asked.profile.empty() && problem.choices.profile.empty() && chosen.name == "legacy";
  if (is_open && old_files == OldFiles::standard)
    chosen = {"standard", "the rules of the old programs do not answer this"};
  else if (is_open && !why_not("legacy").empty())
    chosen = {"standard", fmt::format("{} says of legacy: {}", asked.file.path, why_not("legacy"))};
  if (const std::string why = why_not(chosen.name); !why.empty())
    throw UsageError(fmt::format("{} says of profile {}: {}", asked.file.path, chosen.name, why));
  return chosen;
}

ConfiguredProblem configured(Problem problem, const std::vector<Override>& overrides) {
  problem = with_named_files(std::move(problem), overrides);
  std::vector<Override> left = set_plan(problem, overrides);
  return {std::move(problem), std::move(left)};
}

PlannedCase planned(const AskedCase& asked, const Problem& problem) {
  PlannedCase plan;
  plan.profile = profile_for(asked, problem);
  plan.overrides = asked.overrides(plan.profile.name);
  ConfiguredProblem made = configured(problem, plan.overrides);
  plan.problem = with_followed_points(std::move(made.problem));
  plan.prepared = prepare(plan.problem, plan.profile.name, made.overrides);
  plan.warnings = joined(plan.prepared.warnings, look_ahead(plan.problem, plan.prepared));
  return plan;
}

}  // namespace keyblock::study
