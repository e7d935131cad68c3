// Applies presets, then settings in their order, then checks their consistency.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/settings_of.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "base/error.hpp"
#include "settings/profile.hpp"
#include "settings/setting_row.hpp"

namespace keyblock {
namespace {

// If springs stop impacts, all contacts need springs. Other forces are found only at the end of the step, where blocks
// would overlap.
void require_springs(const Settings& settings, int joint_materials) {
  if (settings.standard.impact != ImpactLaw::springs) return;
  for (int material = 0; material < joint_materials; ++material) {
    const Enforcement enforcement = settings.standard.enforcement.of(material);
    if (enforcement == Enforcement::lagrange || enforcement == Enforcement::augmented)
      refuse_value("impact", "jump, or enforcement = penalty with springs", "springs");
  }
}

// Rejects settings that contradict each other.
void require_consistent(const Settings& settings, int joint_materials) {
  if (settings.dynamics == Dynamics::shi) {
    if (settings.step_control == StepControl::error)
      refuse_value("step_control", "constant or shi under dynamics shi", "error");
    return;
  }
  require_springs(settings, joint_materials);
}

// An invalid setting of the case file is reported at its place in the file.
void set_as_in_file(Settings& settings, const RunChoices& choices) {
  for (std::size_t i = 0; i < choices.settings.size(); ++i) {
    const auto& [name, value] = choices.settings[i];
    try {
      set(settings, name, value);
    } catch (const std::invalid_argument& error) {
      throw InputError(i < choices.setting_places.size() ? choices.setting_places[i] : choices.place, error.what());
    }
  }
}

// Requires settings that are valid for the materials of the file and consistent.
void require_sound(const Settings& settings, const Analysis& analysis) {
  const int joint_materials = static_cast<int>(analysis.joint_materials.size());
  require_materials(settings, static_cast<int>(analysis.block_materials.size()), joint_materials);
  require_consistent(settings, joint_materials);
  if (!settings.body_acceleration.file.empty() && settings.body_acceleration.curve.times.empty())
    throw std::invalid_argument("setting body_acceleration_file: the file was not read");
}

const std::string* read_by_standard_alone(const std::vector<Override>& overrides) {
  const auto found = std::ranges::find_if(
      overrides, [](const Override& setting) { return read_alone_by(setting.first) == Dynamics::standard; });
  return found == overrides.end() ? nullptr : &found->first;
}

bool names_carry_over(const std::vector<Override>& settings) {
  return std::ranges::any_of(settings,
                             [](const Override& setting) { return setting.first.starts_with("velocity_carry_over"); });
}

// A file without velocity carry-over describes equilibrium; only settings that request motion change that.
void carry_what_moves(Settings& settings, const Analysis& analysis, const RunChoices& choices,
                      const std::vector<Override>& overrides) {
  if (settings.dynamics != Dynamics::standard || settings.standard.motion == MotionRule::equilibrium) return;
  if (analysis.velocity_carry_over != 0 || names_carry_over(choices.settings) || names_carry_over(overrides)) return;
  settings.velocity_carry_over = 1;
}

}  // namespace

ChosenProfile profile_unasked(const Problem& problem, const std::vector<Override>& overrides) {
  const std::string& profile = problem.choices.profile;
  const std::vector<std::string> known = profile_names();
  if (!profile.empty() && std::ranges::find(known, profile) == known.end())
    throw InputError(problem.choices.profile_place,
                     fmt::format("expected a profile, one of {}, found \"{}\"", fmt::join(known, ", "), profile));
  if (!profile.empty()) return {profile, "set in the case file"};
  if (problem.has_own_case) return {"standard", "the case is Keyblock's own"};
  if (const std::string* name = read_by_standard_alone(overrides))
    return {"standard", fmt::format("it alone reads the setting {}", *name)};
  return {"legacy", "input in a format of Shi's or the Berkeley program"};
}

ChosenProfile chosen_profile(const Problem& problem, const std::string& asked, const std::vector<Override>& overrides) {
  if (asked.empty()) return profile_unasked(problem, overrides);
  const ChosenProfile unasked = profile_unasked(problem, overrides);
  return asked == unasked.name
             ? unasked
             : ChosenProfile{asked, fmt::format("requested; else {}, because {}", unasked.name, unasked.why)};
}

std::string profile_of(const Problem& problem, const std::string& asked, const std::vector<Override>& overrides) {
  return asked.empty() ? profile_unasked(problem, overrides).name : asked;
}

Settings settings_of(const Problem& problem, const std::string& profile, const std::vector<Override>& overrides) {
  const Analysis& analysis = *problem.analysis;
  const RunChoices& choices = problem.choices;
  Settings settings = profile_settings(profile, analysis, [&](Settings& changed) {
    set_as_in_file(changed, choices);
    for (const auto& [name, value] : overrides)
      set(changed, name, in_units(problem.units, name, value, measure_of_setting(name)));
  });
  carry_what_moves(settings, analysis, choices, overrides);
  if (settings.dynamics == Dynamics::standard) settings.quirks = settings.quirks.without_those_of_the_step();
  try {
    require_sound(settings, analysis);
  } catch (const std::invalid_argument& error) {
    if (choices.settings.empty() || !overrides.empty()) throw;
    throw InputError(choices.place, error.what());
  }
  return settings;
}

}  // namespace keyblock
