// Defines a row of the table of settings: how its value is written and read, for the run or for one material.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "settings/permitted.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Text form of values of one type. `read` throws std::invalid_argument with the name of the setting and the expected
/// values.
template <class T>
struct ValueText {
  std::function<std::string(const T&)> write;
  std::function<T(const std::string& name, const std::string& text)> read;
  Permitted permitted;
};

ValueText<double> real(Range range);
/// An absent value is the empty text.
ValueText<std::optional<double>> real_or_nothing(Range range);
ValueText<int> whole(int least);
ValueText<std::string> any_text();
ValueText<bool> off_or_on();

[[noreturn]] void refuse_value(const std::string& name, const std::string& expected, const std::string& found,
                               const std::string& hint = {});

/// Returns the text form of values with one word each. `gone`: former words, each with its replacement.
template <class E>
ValueText<E> one_of(const std::vector<std::pair<E, std::string>>& words,
                    const std::vector<std::pair<std::string, std::string>>& gone = {}) {
  std::string expected;
  for (const auto& [value, word] : words) expected += (expected.empty() ? "one of " : ", ") + word;
  const auto read = [words, gone, expected](const std::string& name, const std::string& text) {
    for (const auto& [value, word] : words)
      if (word == text) return value;
    for (const auto& [word, hint] : gone)
      if (word == text) refuse_value(name, expected, text, hint);
    refuse_value(name, expected, text);
  };
  const auto write = [words](const E& wanted) {
    for (const auto& [value, word] : words)
      if (value == wanted) return word;
    return std::string();
  };
  std::vector<std::string> permitted;
  for (const auto& [value, word] : words) permitted.push_back(word);
  return {write, read, {expected, std::nullopt, false, std::move(permitted)}};
}

enum class Materials { of_blocks, of_joints };

/// Other choice without which the setting is not read, besides its dynamics: "integrator = newmark".
struct ReadUnder {
  std::string choice;
  std::function<bool(const Settings&)> holds;
};

/// Values of a setting for single materials, numbered from 0.
struct MaterialRow {
  Materials materials;
  std::function<std::vector<int>(const Settings&)> given;
  std::function<std::string(const Settings&, int material)> write;
  std::function<void(Settings&, int material, const std::string& name, const std::string& text)> read;
};

struct SettingRow {
  std::string name;
  std::string meaning;  ///< one phrase, with the unit
  std::function<std::string(const Settings&)> write;
  std::function<void(Settings&, const std::string& text)> read;
  std::optional<MaterialRow> per_material;
  Permitted permitted;
  std::optional<Dynamics> dynamics = std::nullopt;  ///< dynamics that reads it; empty: both
  std::optional<ReadUnder> read_under = std::nullopt;
};

/// Returns a row. `of` gives the member of the settings, constant or not.
template <class T, class Of>
SettingRow row(const std::string& name, const std::string& meaning, Of of, const ValueText<T>& text) {
  return {name,
          meaning,
          [=](const Settings& s) { return text.write(of(s)); },
          [=](Settings& s, const std::string& value) { of(s) = text.read(name, value); },
          std::nullopt,
          text.permitted};
}

/// Returns a row of a PerMaterial member: `name` sets the common value, `name.N` that of material N, counted from 1.
template <class T, class Of>
SettingRow row(Materials materials, const std::string& name, const std::string& meaning, Of of,
               const ValueText<T>& text) {
  SettingRow common = row(
      name, meaning, [=](auto& s) -> auto& { return of(s).common; }, text);
  common.per_material = {materials,
                         [=](const Settings& s) {
                           std::vector<int> numbers;
                           for (const auto& [number, value] : of(s).own) numbers.push_back(number);
                           return numbers;
                         },
                         [=](const Settings& s, int material) { return text.write(of(s).of(material)); },
                         [=](Settings& s, int material, const std::string& full_name, const std::string& value) {
                           of(s).own[material] = text.read(full_name, value);
                         }};
  return common;
}

/// Returns the rows of all settings, in the order in which users see them.
std::vector<SettingRow> setting_rows();

}  // namespace keyblock
