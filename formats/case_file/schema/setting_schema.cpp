// Makes the schema of each setting from its row in the table of settings.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/schema/setting_schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

#include "formats/case_file/schema/case_titles.hpp"
#include "formats/case_file/schema/limits.hpp"
#include "problem/units/measure.hpp"
#include "settings/settings_table.hpp"

namespace keyblock::formats {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kOneOf = "one of ";

std::string_view group_of(const SettingText& setting) {
  if (setting.name.starts_with("quirk.")) return "Rules of the Berkeley program";
  if (!setting.dynamics) return "All profiles";
  return *setting.dynamics == Dynamics::shi ? "Profile legacy" : "Profiles standard, draft, reference";
}

// Words of "one of off, on".
Json words_of(std::string_view expected) {
  Json words = Json::array();
  expected.remove_prefix(kOneOf.size());
  while (!expected.empty()) {
    const std::size_t end = std::min(expected.find(", "), expected.size());
    words.push_back(std::string(expected.substr(0, end)));
    expected.remove_prefix(std::min(end + 2, expected.size()));
  }
  // A file may write true and false as well.
  if (words == Json({"off", "on"})) words.insert(words.end(), {false, true});
  return words;
}

bool takes(const std::string& name, double value) {
  Settings settings;
  try {
    set(settings, name, fmt::format("{}", value));
  } catch (const std::invalid_argument&) {
    return false;
  }
  return true;
}

Json schema_of(const SettingText& setting) {
  Json schema = {{"type", {"string", "number", "boolean"}},
                 {"title", title_of("set", setting.name)},
                 {"description", fmt::format("{}. Permitted: {}", setting.meaning, setting.expected)},
                 {"x-permitted", setting.expected},
                 {"x-group", group_of(setting)}};
  if (setting.expected.starts_with(kOneOf)) schema["enum"] = words_of(setting.expected);
  // A number that may be absent counts.
  if (setting.expected.find("number") == std::string::npos) return schema;
  const Measure measure = measure_of_setting(setting.name).value_or(measures::kNumber);
  const std::string unit = unit_of(measure, Units{});
  schema["x-unit"] = unit.empty() ? "none" : unit;
  if (measure.of_slice) schema["x-of-slice"] = true;
  put_limits(schema, setting.expected, [&](double value) { return takes(setting.name, value); });
  return schema;
}

}  // namespace

Json setting_properties() {
  Json properties = Json::object();
  for (const SettingText& setting : list(Settings{})) properties[setting.name] = schema_of(setting);
  return properties;
}

}  // namespace keyblock::formats
