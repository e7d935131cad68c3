// Reads the files that settings name, one line per setting.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "api/named_files.hpp"

#include <utility>

#include "formats/berkeley/body_acceleration.hpp"
#include "formats/registry.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;

void read_named(Problem& problem, const std::string& name, const std::string& value) {
  if (names_a_file(name) && !value.empty() && problem.analysis)
    problem.analysis->body_acceleration = formats::read_body_acceleration(formats::load(value), problem.units);
}

fs::path folder_of(const RunChoices& choices, std::size_t setting) {
  return fs::path(choices.setting_places[setting].file.text()).parent_path();
}

}  // namespace

bool names_a_file(const std::string& setting) {
  return setting == "body_acceleration_file";
}

std::string from_folder(const fs::path& folder, const std::string& name, const std::string& value) {
  return names_a_file(name) && !value.empty() ? (folder / value).string() : value;
}

std::vector<std::string> named_files(const std::vector<Override>& settings) {
  std::vector<std::string> files;
  for (const auto& [name, value] : settings)
    if (names_a_file(name) && !value.empty()) files.push_back(value);
  return files;
}

Problem with_named_files(Problem problem, const std::vector<Override>& overrides) {
  RunChoices& choices = problem.choices;
  for (std::size_t i = 0; i < choices.settings.size() && i < choices.setting_places.size(); ++i) {
    auto& [name, value] = choices.settings[i];
    value = from_folder(folder_of(choices, i), name, value);
    read_named(problem, name, value);
  }
  for (const auto& [name, value] : overrides) read_named(problem, name, value);
  return problem;
}

void name_files_from(const fs::path& folder, RunChoices& choices) {
  const fs::path to = fs::weakly_canonical(fs::absolute(folder));
  for (std::size_t i = 0; i < choices.settings.size() && i < choices.setting_places.size(); ++i) {
    auto& [name, value] = choices.settings[i];
    if (!names_a_file(name) || value.empty() || fs::path(value).is_absolute()) continue;
    const fs::path from = fs::weakly_canonical(fs::absolute(folder_of(choices, i) / "."));
    if (from != to) value = fs::weakly_canonical(from / value).lexically_relative(to).generic_string();
  }
}

}  // namespace keyblock
