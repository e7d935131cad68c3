// Every setting by name: what `--set key=value` may set and what run.json reports.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "problem/units/measure.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// A setting the user gave on top of the profile: name and value as text.
using Override = std::pair<std::string, std::string>;

/// A setting as people see it.
struct SettingText {
  std::string name;
  std::string value;
  std::string meaning;  ///< one phrase, with the unit
  bool is_number = false;
  std::string expected = {};                        ///< permitted values, in words
  std::optional<Dynamics> dynamics = std::nullopt;  ///< that read it; nothing: both
};

/// All settings in the order of the table; behind those that materials may have of their own, `name.N` for each that
/// does.
std::vector<SettingText> list(const Settings& settings);

/// Sets one setting from text. Throws std::invalid_argument with the expected values if the name or the value
/// is not valid. `name.N` sets the value of material N, counted from 1, where the setting is one of materials.
void set(Settings& settings, const std::string& name, const std::string& value);

/// What the number of a setting measures, as the brackets of its meaning say; nothing where there is none of this name.
std::optional<Measure> measure_of_setting(const std::string& name);

/// A value in the units of a case: "2 ms" is "0.002" where it has seconds and `measure` is a time. Other texts are left
/// as they are. Throws std::invalid_argument where the unit is of another kind, or the case does not declare what it
/// takes.
std::string in_units(const Units& units, const std::string& name, const std::string& value,
                     const std::optional<Measure>& measure);

/// The dynamics that alone read this setting; nothing where both do, or there is none of this name.
std::optional<Dynamics> read_alone_by(const std::string& name);

/// Why this setting has no effect beside the others: "is read under integrator = newmark alone"; empty where it has, or
/// there is none of this name.
std::string why_unread(const Settings& settings, const std::string& name);

/// Throws std::invalid_argument where a value was given for a material that is not there.
void require_materials(const Settings& settings, int block_materials, int joint_materials);

}  // namespace keyblock
