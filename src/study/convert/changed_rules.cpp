// Takes the profile as `run` chooses it, and the rules by the settings that differ.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/convert/changed_rules.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "base/sentences/sentences.hpp"
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
  if (old_profile != new_profile) {
    Facts facts;
    facts.names = {{"profile", new_profile}, {"profile_before", old_profile}};
    warnings.push_back(warning_of({"profile_changes", std::move(facts)}, place));
  }
  if (const auto changed = settings_of_dialect(*before.analysis, after.analysis->dialect); !changed.empty()) {
    const Facts facts{{{"count", changed.size()}}, {{"changed", fmt::format("{}", fmt::join(changed, "; "))}}};
    warnings.push_back(warning_of({"dialect_changes", facts}, place));
  }
  return warnings;
}

}  // namespace keyblock::study
