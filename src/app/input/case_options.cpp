// Declares the options of a case in turn.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/input/case_options.hpp"

#include <fmt/format.h>

#include "app/option_checks.hpp"
#include "base/error.hpp"
#include "settings/profile.hpp"

namespace keyblock {

CaseOptionList add_case_options(CLI::App& options, CaseOptions& chosen, const std::string& about_files) {
  CaseOptionList list{};
  list.files = options.add_option("files", chosen.paths, about_files);
  list.profile =
      options
          .add_option(
              "--profile", chosen.profile,
              "preset of all settings (default: the profile of the case file, else standard). Files of Shi's and the "
              "Berkeley programs default to legacy, except in fos and sif")
          ->check(one_word_of(profile_names()));
  list.sets = options.add_option("--set", chosen.sets, "change one setting of the profile; may be repeated")
                  ->type_name("KEY=VALUE")
                  ->take_all();
  list.values = options
                    .add_option("--at", chosen.values,
                                "give the case file another value at a JSON pointer, such as "
                                "/analysis/joint_materials/bedding/friction_angle_deg=25; names and * stand for "
                                "numbers of list items; may be repeated")
                    ->type_name("POINTER=VALUE")
                    ->take_all();
  list.settings_file =
      options
          .add_option("--settings-file", chosen.settings_file,
                      "read settings from FILE, one name = value per line; --set and --profile override it")
          ->type_name("FILE");
  list.reading = add_drawing_options(options, chosen.reading);
  return list;
}

AskedCase case_of(const CaseOptions& chosen) {
  AskedCase asked = asked_case(
      {chosen.paths, chosen.settings_file, chosen.profile, overrides_of(chosen.sets), chosen.reading.choices});
  for (const std::string& value : chosen.values) asked.values.push_back(case_value_of(value));
  take_layers(asked.files, chosen.reading.layers);
  return asked;
}

std::vector<Override> overrides_of(const std::vector<std::string>& sets) {
  std::vector<Override> overrides;
  for (const std::string& text : sets) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) throw UsageError(fmt::format("--set: expected key=value, found \"{}\"", text));
    overrides.emplace_back(text.substr(0, equals), text.substr(equals + 1));
  }
  return overrides;
}

}  // namespace keyblock
