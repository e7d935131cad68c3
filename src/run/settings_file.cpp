// Tries each line on settings made up for it, so that an error is reported at its line.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/settings_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "run/cover_settings.hpp"
#include "settings/profile.hpp"
#include "settings/settings_table.hpp"

namespace keyblock {
namespace {

constexpr const char* kSpace = " \t\r";

/// Part of a line without surrounding space, and its first column (from 1).
struct Word {
  std::string text;
  int column = 1;
};

Word word_of(const std::string& line, std::size_t begin, std::size_t end) {
  const std::size_t first = std::min(line.find_first_not_of(kSpace, begin), end);
  if (first == end) return {"", static_cast<int>(end) + 1};
  const std::size_t last = line.find_last_not_of(kSpace, end - 1);
  return {line.substr(first, last - first + 1), static_cast<int>(first) + 1};
}

bool is_known(const std::string& name) {
  if (is_of_plan(name)) return true;
  const Settings settings;
  return std::ranges::any_of(list(settings), [&](const SettingText& setting) {
    return name == setting.name || name.starts_with(setting.name + ".");
  });
}

}  // namespace

void require_setting(const std::string& name, const std::string& value) {
  const Units any{"m", "kg", "s"};  // the case's own units are unknown here; any units show which values are times
  if (is_of_plan(name)) {
    CoverPlan plan;
    set(plan, name, in_units(any, name, value, measure_of_mesh_setting(name)));
  } else {
    Settings settings;
    set(settings, name, in_units(any, name, value, measure_of_setting(name)));
  }
}

SettingsFile read_settings(const std::string& file_name, const std::string& text) {
  SettingsFile file;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const Word whole = word_of(line, 0, line.size());
    if (whole.text.empty() || whole.text.starts_with('#')) continue;
    const std::size_t equals = line.find('=');
    const Word name = word_of(line, 0, equals == std::string::npos ? line.size() : equals);
    const auto refuse = [&](const Word& at, const std::string& sentence) {
      throw InputError({file_name, number, at.column}, sentence);
    };
    if (equals == std::string::npos || name.text.empty())
      refuse(whole, fmt::format("expected name = value, found \"{}\"", whole.text));
    const Word value = word_of(line, equals + 1, line.size());
    const bool is_profile = name.text == "profile";
    const bool is_second = is_profile
                               ? !file.profile.empty()
                               : std::ranges::find(file.settings, name.text, &Override::first) != file.settings.end();
    if (is_second) refuse(name, fmt::format("expected each name once, found \"{}\" again", name.text));
    if (is_profile) {
      const std::vector<std::string> known = profile_names();
      if (std::ranges::find(known, value.text) == known.end())
        refuse(value, fmt::format("expected a profile, one of {}, found \"{}\"", fmt::join(known, ", "), value.text));
      file.profile = value.text;
      continue;
    }
    try {
      require_setting(name.text, value.text);
    } catch (const std::invalid_argument& error) {
      refuse(is_known(name.text) ? value : name, error.what());
    }
    file.settings.emplace_back(name.text, value.text);
  }
  return file;
}

std::string settings_text(const SettingsFile& file, const std::string& comment) {
  std::string text;
  std::istringstream lines(comment);
  for (std::string line; std::getline(lines, line);) text += "# " + line + "\n";
  if (!file.profile.empty()) text += fmt::format("profile = {}\n", file.profile);
  for (const auto& [name, value] : file.settings) text += fmt::format("{} = {}\n", name, value);
  return text;
}

}  // namespace keyblock
