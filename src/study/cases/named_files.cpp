// One line a setting that names a file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/cases/named_files.hpp"

#include "formats/berkeley/body_acceleration.hpp"
#include "formats/registry.hpp"

namespace keyblock::study {
namespace {

namespace fs = std::filesystem;

// The value becomes the name from the folder at hand.
void read_named(Problem& problem, const std::string& name, std::string& value, const fs::path& folder) {
  if (name != "body_acceleration_file" || !problem.analysis) return;
  value = (folder / value).string();
  problem.analysis->body_acceleration = formats::read_body_acceleration(formats::load(value));
}

}  // namespace

Problem with_named_files(Problem problem, const std::vector<Override>& overrides, const fs::path& folder) {
  RunChoices& choices = problem.choices;
  for (std::size_t i = 0; i < choices.settings.size() && i < choices.setting_places.size(); ++i)
    read_named(problem, choices.settings[i].first, choices.settings[i].second,
               fs::path(choices.setting_places[i].file.text()).parent_path());
  for (auto [name, value] : overrides) read_named(problem, name, value, folder);
  return problem;
}

}  // namespace keyblock::study
