// Takes the profile as `run` chooses it, and the rules by the settings that differ.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/convert/changed_rules.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "run/settings_of.hpp"
#include "settings/profile.hpp"
#include "settings/settings_table.hpp"

namespace keyblock::study {
namespace {

std::string profile_of_run(const formats::Content& content) {
  if (content.choices && !content.choices->profile.empty()) return content.choices->profile;
  Problem problem;
  problem.has_own_case = content.is_own_case;
  return profile_of(problem, {});
}

// Returns lines such as "quirk.start_velocity_slots = off, before on".
std::vector<std::string> settings_of_dialect(const Analysis& before, AnalysisDialect dialect) {
  Analysis after = before;
  after.dialect = dialect;
  const std::vector<SettingText> old_ones = list(profile_settings("legacy", before));
  const std::vector<SettingText> new_ones = list(profile_settings("legacy", after));
  std::vector<std::string> changed;
  for (std::size_t i = 0; i < old_ones.size() && i < new_ones.size(); ++i)
    if (old_ones[i].name == new_ones[i].name && old_ones[i].value != new_ones[i].value)
      changed.push_back(fmt::format("{} = {}, before {}", new_ones[i].name, new_ones[i].value, old_ones[i].value));
  return changed;
}

}  // namespace

Warnings changed_rules(const formats::Content& before, const formats::Content& after, const Place& place) {
  Warnings warnings;
  if (!before.analysis || !after.analysis) return warnings;
  const std::string old_profile = profile_of_run(before);
  const std::string new_profile = profile_of_run(after);
  if (old_profile != new_profile)
    warnings.push_back({"profile_changes", place,
                        fmt::format("without --profile, a run takes profile {} for the written files and {} for those "
                                    "read: --profile {} keeps to that",
                                    new_profile, old_profile, old_profile)});
  if (const auto changed = settings_of_dialect(*before.analysis, after.analysis->dialect); !changed.empty())
    warnings.push_back(
        {"dialect_changes", place,
         fmt::format("profile legacy has other rules for the written dialect: {}", fmt::join(changed, "; "))});
  return warnings;
}

}  // namespace keyblock::study
