// Declares the table of all settings by name, for `--set key=value` and run.json.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "problem/units/measure.hpp"
#include "settings/permitted.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Setting given by the user on top of the profile: name and value as text.
using Override = std::pair<std::string, std::string>;

/// Setting in the form shown to users.
struct SettingText {
  std::string name;
  std::string value;
  std::string meaning;     ///< one phrase, with the unit
  bool is_number = false;  ///< the value, which may be absent
  Permitted permitted = {};
  std::optional<Dynamics> dynamics = std::nullopt;  ///< dynamics that reads it; empty: both
};

/// Returns all settings in the order of the table. A setting with values of materials is followed by `name.N` for each
/// of them.
std::vector<SettingText> list(const Settings& settings);

/// Sets one setting from text. `name.N` sets the value of material N, counted from 1, if the setting has values of
/// materials. Throws std::invalid_argument with the expected values if the name or the value is not valid.
void set(Settings& settings, const std::string& name, const std::string& value);

/// Returns the quantity that a setting measures, from the brackets of its meaning; nothing for an unknown name.
std::optional<Measure> measure_of_setting(const std::string& name);

/// Converts a value to the units of a case: "2 ms" is "0.002" if it has seconds and `measure` is a time. Other texts
/// stay unchanged. Throws std::invalid_argument if the unit is of another kind, or if the case does not declare the
/// units needed.
std::string in_units(const Units& units, const std::string& name, const std::string& value,
                     const std::optional<Measure>& measure);

/// Returns the only dynamics that reads this setting; nothing if both do, or for an unknown name.
std::optional<Dynamics> read_alone_by(const std::string& name);

/// Returns the reason why this setting has no effect with the others: "is read under integrator = newmark alone". Empty
/// if it has an effect, or for an unknown name.
std::string why_unread(const Settings& settings, const std::string& name);

/// Throws std::invalid_argument if a value was given for a material that does not exist.
void require_materials(const Settings& settings, int block_materials, int joint_materials);

}  // namespace keyblock
