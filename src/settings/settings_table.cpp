// Lists and changes settings by name, from the rows of setting_rows.cpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/settings_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>

#include "base/nearest.hpp"
#include "settings/setting_row.hpp"

namespace keyblock {
namespace {

// Words at the end of a meaning.
constexpr std::array<std::pair<std::string_view, Measure>, 5> kMeasures{{{"[time]", measures::kTime},
                                                                         {"[1/time]", measures::kRate},
                                                                         {"[length/time^2]", measures::kAcceleration},
                                                                         {"[force/length]", measures::kStiffness},
                                                                         {"[degree]", measures::kDegrees}}};

const std::vector<SettingRow>& table() {
  static const std::vector<SettingRow> rows = setting_rows();
  return rows;
}

const SettingRow* find_row(const std::string& name) {
  const auto found = std::ranges::find(table(), name, &SettingRow::name);
  return found == table().end() ? nullptr : &*found;
}

/// Parts of "restitution.2": the row before the last point and the material after it, from 0.
struct MaterialSetting {
  const SettingRow* row = nullptr;
  int material = 0;
};

MaterialSetting material_setting(const std::string& name) {
  const std::size_t point = name.rfind('.');
  if (point == std::string::npos) return {};
  const SettingRow* row = find_row(name.substr(0, point));
  if (row == nullptr || !row->per_material) return {};
  int number = 0;
  const char* end = name.data() + name.size();
  const auto [last, error] = std::from_chars(name.data() + point + 1, end, number);
  if (error != std::errc{} || last != end || number < 1)
    refuse_value(name, "a material number from 1 behind the point", name.substr(point + 1));
  return {row, number - 1};
}

std::string numbered(const SettingRow& row, int material) {
  return fmt::format("{}.{}", row.name, material + 1);
}

const char* noun(Materials materials) {
  return materials == Materials::of_blocks ? "block" : "joint";
}

// Words of case files and other programs for the effect of a setting.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kOtherWords{{{"step_count", "steps"},
                                                                                    {"dt", "time_step"},
                                                                                    {"penalty", "contact_penalty"},
                                                                                    {"statics", "motion"},
                                                                                    {"init", "start"}}};

// Returns the place of quantities that users look for among the settings.
std::string where_it_is(std::string_view name) {
  constexpr std::array<std::string_view, 9> kOfJoints{
      "friction_angle_deg", "friction_angle", "friction", "phi", "cohesion",
      "tensile_strength",   "tension",        "c",        "fric"};
  constexpr std::array<std::string_view, 8> kOfBlocks{"youngs_modulus", "young",       "modulus",  "poissons_ratio",
                                                      "density",        "unit_weight", "strength", "dilation_deg"};
  if (std::ranges::find(kOfJoints, name) != kOfJoints.end())
    return "; it is a value of joint_materials in the case file, or of the analysis file; joint_strength_factor scales "
           "friction, cohesion and tensile strength of all joints";
  if (std::ranges::find(kOfBlocks, name) != kOfBlocks.end())
    return "; it is a value of block_materials in the case file, or of the analysis file";
  if (name == "gravity") return "; it is a value of the case file, in the section analysis";
  return {};
}

std::string no_such_setting(const std::string& name) {
  std::vector<std::string> names;
  for (const SettingRow& row : table()) names.push_back(row.name);
  const auto other =
      std::ranges::find(kOtherWords, std::string_view(name), [](const auto& pair) { return pair.first; });
  if (const std::string where = where_it_is(name); !where.empty())
    return fmt::format("there is no setting \"{}\"{}", name, where);
  return fmt::format(
      "there is no setting \"{}\"{} (`keyblock run --settings` lists them)", name,
      other != kOtherWords.end() ? fmt::format("; did you mean \"{}\"?", other->second) : nearest_words(name, names));
}

}  // namespace

std::vector<SettingText> list(const Settings& settings) {
  std::vector<SettingText> texts;
  for (const SettingRow& row : table()) {
    const std::string value = row.write(settings);
    std::string meaning = row.meaning;
    if (row.per_material)
      meaning += fmt::format(". For {} material N alone: {}.N", noun(row.per_material->materials), row.name);
    texts.push_back({row.name, value, meaning, row.permitted.range && !value.empty(), row.permitted, row.dynamics});
    if (!row.per_material) continue;
    for (int material : row.per_material->given(settings)) {
      const std::string own = row.per_material->write(settings, material);
      texts.push_back(
          {numbered(row, material), own, meaning, row.permitted.range && !own.empty(), row.permitted, row.dynamics});
    }
  }
  return texts;
}

void set(Settings& settings, const std::string& name, const std::string& value) {
  if (const SettingRow* row = find_row(name)) return row->read(settings, value);
  const auto [row, material] = material_setting(name);
  if (row == nullptr) throw std::invalid_argument(no_such_setting(name));
  row->per_material->read(settings, material, name, value);
}

std::optional<Measure> measure_of_setting(const std::string& name) {
  const SettingRow* row = find_row(name);
  if (row == nullptr) row = find_row(name.substr(0, name.rfind('.')));
  if (row == nullptr) return std::nullopt;
  for (const auto& [words, measure] : kMeasures)
    if (row->meaning.find(words) != std::string::npos) return measure;
  return measures::kNumber;
}

std::string in_units(const Units& units, const std::string& name, const std::string& value,
                     const std::optional<Measure>& measure) {
  const Measure of = measure.value_or(measures::kNumber);
  const std::optional<Quantity> quantity = quantity_in(value);
  if (of == measures::kNumber || !quantity || !unit_named(quantity->unit)) return value;
  const Converted found = converted(value, of, units);
  if (found.lacks_units)
    throw std::invalid_argument(
        fmt::format("setting {}: expected a number in the units of the case, which declares none to convert to "
                    "(\"units\" of a case file), found \"{}\"",
                    name, value));
  if (!found.number) refuse_value(name, "a number, or " + example_of(of), value);
  return fmt::format("{}", *found.number);
}

std::optional<Dynamics> read_alone_by(const std::string& name) {
  const SettingRow* row = find_row(name.substr(0, name.find('.')));
  return row ? row->dynamics : std::nullopt;
}

std::string why_unread(const Settings& settings, const std::string& name) {
  const SettingRow* row = find_row(name);
  if (row == nullptr) row = material_setting(name).row;
  if (row == nullptr) return {};
  if (row->dynamics && *row->dynamics != settings.dynamics)
    return fmt::format("is read by dynamics {} alone", *row->dynamics == Dynamics::shi ? "shi" : "standard");
  if (row->read_under && !row->read_under->holds(settings))
    return fmt::format("is read under {} alone", row->read_under->choice);
  return {};
}

void require_materials(const Settings& settings, int block_materials, int joint_materials) {
  for (const SettingRow& row : table()) {
    if (!row.per_material) continue;
    const Materials materials = row.per_material->materials;
    const int count = materials == Materials::of_blocks ? block_materials : joint_materials;
    for (int material : row.per_material->given(settings)) {
      if (material >= count)
        refuse_value(numbered(row, material), fmt::format("a {} material from 1 to {}", noun(materials), count),
                     fmt::format("{}", material + 1));
    }
  }
}

}  // namespace keyblock
