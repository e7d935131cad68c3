// Makes the schema of each setting from its row in the table of settings.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/schema/setting_schema.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "formats/case_file/schema/case_titles.hpp"
#include "formats/case_file/schema/limits.hpp"
#include "problem/units/measure.hpp"
#include "settings/settings_table.hpp"

namespace keyblock::formats {
namespace {

using Json = nlohmann::ordered_json;

std::string_view group_of(const SettingText& setting) {
  if (setting.name.starts_with("quirk.")) return "Rules of the Berkeley program";
  if (!setting.dynamics) return "All profiles";
  return *setting.dynamics == Dynamics::shi ? "Profile legacy" : "Profiles standard, draft, reference";
}

// A file may write true and false as well.
Json words_of(const std::vector<std::string>& permitted) {
  Json words = permitted;
  if (words == Json({"off", "on"})) words.insert(words.end(), {false, true});
  return words;
}

Json schema_of(const SettingText& setting) {
  Json schema = {{"type", {"string", "number", "boolean"}},
                 {"title", title_of("set", setting.name)},
                 {"description", fmt::format("{}. Permitted: {}", setting.meaning, setting.permitted.expected)},
                 {"x-permitted", setting.permitted.expected},
                 {"x-group", group_of(setting)}};
  if (!setting.permitted.words.empty()) schema["enum"] = words_of(setting.permitted.words);
  if (!setting.permitted.range) return schema;
  const Measure measure = measure_of_setting(setting.name).value_or(measures::kNumber);
  const std::string unit = unit_of(measure, Units{});
  schema["x-unit"] = unit.empty() ? "none" : unit;
  if (measure.of_slice) schema["x-of-slice"] = true;
  put_limits(schema, *setting.permitted.range);
  return schema;
}

}  // namespace

Json setting_properties() {
  Json properties = Json::object();
  for (const SettingText& setting : list(Settings{})) properties[setting.name] = schema_of(setting);
  return properties;
}

}  // namespace keyblock::formats
