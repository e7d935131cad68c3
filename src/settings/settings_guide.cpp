// Finds the values that a profile takes from the file by two invented files that differ in all their values.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/settings_guide.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <nlohmann/json.hpp>

#include "settings/profile.hpp"
#include "settings/settings_table.hpp"

namespace keyblock {
namespace {

Analysis one_file() {
  Analysis analysis;
  analysis.dialect = AnalysisDialect::shi;
  analysis.block_materials.resize(1);
  analysis.block_materials[0].density = analysis.block_materials[0].unit_weight = 1;
  analysis.block_materials[0].youngs_modulus = 1;
  analysis.joint_materials.resize(1);
  analysis.velocity_carry_over = 1;
  analysis.step_count = 1;
  analysis.time_step = 1;
  analysis.contact_penalty = 1;
  analysis.allowed_displacement_ratio = 1;
  return analysis;
}

Analysis another_file() {
  Analysis analysis = one_file();
  analysis.dialect = AnalysisDialect::ddaml;
  analysis.velocity_carry_over = 0;
  analysis.step_count = 2;
  analysis.time_step = 2;
  analysis.contact_penalty = 2;
  analysis.allowed_displacement_ratio = 2;
  analysis.gravity = 2;
  analysis.automatic_time_step = !analysis.automatic_time_step;
  analysis.automatic_penalty = !analysis.automatic_penalty;
  analysis.plane_strain = !analysis.plane_strain;
  analysis.rotation = analysis.rotation == Rotation::exact ? Rotation::first_order : Rotation::exact;
  analysis.open_close_limit += 1;
  for (double* constant : {&analysis.open_close.closing_ratio, &analysis.open_close.opening_ratio,
                           &analysis.open_close.allowed_penetration, &analysis.open_close.angle_overlap_deg,
                           &analysis.open_close.normal_to_shear_stiffness})
    *constant *= 2;
  return analysis;
}

struct Column {
  std::vector<SettingText> one, other;

  std::string value(std::size_t row) const {
    if (one[row].value != other[row].value) return "(file)";
    return one[row].value.empty() ? "-" : one[row].value;
  }
};

std::string word_for(const std::optional<Dynamics>& dynamics) {
  if (!dynamics) return "both";
  return *dynamics == Dynamics::shi ? "shi" : "standard";
}

// Settings that users most often set.
constexpr std::array<std::string_view, 10> kFirst{"motion",  "steps",      "time_step",   "contact_penalty",
                                                  "gravity", "plane",      "enforcement", "joint_strength_factor",
                                                  "basis",   "restitution"};
constexpr std::string_view kQuirk = "quirk.";

bool is_first(const SettingText& setting) {
  return std::ranges::find(kFirst, setting.name) != kFirst.end();
}

bool is_quirk(const SettingText& setting) {
  return setting.name.starts_with(kQuirk);
}

struct Group {
  const char* title;
  std::function<bool(const SettingText&)> holds;
};

// Every setting is in one of these groups.
std::vector<Group> groups() {
  const auto read_by = [](std::optional<Dynamics> dynamics) {
    return [dynamics](const SettingText& s) { return !is_first(s) && !is_quirk(s) && s.dynamics == dynamics; };
  };
  return {{"set first", is_first},
          {"read by all profiles", read_by(std::nullopt)},
          {"read by dynamics standard alone (profiles standard, draft, reference)", read_by(Dynamics::standard)},
          {"read by dynamics shi alone (profile legacy)", read_by(Dynamics::shi)},
          {"rules of the Berkeley program that look like mistakes; each can be turned off", is_quirk}};
}

// Wraps at spaces; lines after the first have the same indentation.
std::string wrapped(const std::string& text, std::size_t indent) {
  constexpr std::size_t kLine = 118;
  std::string lines(indent, ' ');
  std::size_t length = indent;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    if (length > indent && length + 1 + word.size() > kLine) {
      lines += '\n';
      lines.append(indent, ' ');
      length = indent;
    }
    if (length > indent) {
      lines += ' ';
      ++length;
    }
    lines += word;
    length += word.size();
    at = end + 1;
  }
  lines += '\n';
  return lines;
}

std::string row_of(const std::vector<Column>& columns, std::size_t row) {
  const SettingText& setting = columns[0].one[row];
  std::string text = fmt::format("{:32} ", setting.name);
  for (const Column& column : columns) text += fmt::format("{:15} ", column.value(row));
  text += fmt::format("{}\n", word_for(setting.dynamics));
  return text + wrapped(setting.meaning, 4) + fmt::format("    permitted: {}\n", setting.permitted.expected);
}

// Returns the columns in the order of the profiles.
std::vector<Column> columns_of_profiles() {
  std::vector<Column> columns;
  for (const std::string& profile : profile_names())
    columns.push_back({list(profile_settings(profile, one_file())), list(profile_settings(profile, another_file()))});
  return columns;
}

}  // namespace

std::string settings_json() {
  const std::vector<Column> columns = columns_of_profiles();
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Group& group : groups())
    for (std::size_t row = 0; row < columns[0].one.size(); ++row) {
      const SettingText& setting = columns[0].one[row];
      if (!group.holds(setting)) continue;
      nlohmann::ordered_json values;
      for (std::size_t i = 0; i < columns.size(); ++i) values[profile_names()[i]] = columns[i].value(row);
      rows.push_back({{"name", setting.name},
                      {"group", group.title},
                      {"meaning", setting.meaning},
                      {"permitted", setting.permitted.expected},
                      {"read_by", word_for(setting.dynamics)},
                      {"profiles", values}});
    }
  return rows.dump(1) + "\n";
}

std::string settings_guide() {
  const std::vector<Column> columns = columns_of_profiles();
  std::string table = fmt::format("{:32} ", "setting");
  for (const std::string& profile : profile_names()) table += fmt::format("{:15} ", profile);
  table += "read by\n";
  for (const Group& group : groups()) {
    table += fmt::format("\n# {}\n", group.title);
    for (std::size_t row = 0; row < columns[0].one.size(); ++row)
      if (group.holds(columns[0].one[row])) table += row_of(columns, row);
  }
  return table +
         "\n(file): taken from the analysis file. draft doubles its time_step, or that of --set; reference takes a "
         "quarter;\nboth over the same time. \"read by\": the dynamics that read the setting. Change it by `--set "
         "NAME=VALUE`;\nNAME.N is possible if the meaning names it.\n";
}

}  // namespace keyblock
