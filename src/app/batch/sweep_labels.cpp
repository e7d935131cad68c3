// Takes pointers apart; names of lists lose their plural before a number.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/sweep_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <sstream>
#include <string_view>
#include <tuple>
#include <vector>

#include "formats/case_file/case_measures.hpp"
#include "problem/units/measure.hpp"
#include "settings/settings_table.hpp"
#include "study/sweep/varied_key.hpp"

namespace keyblock {
namespace {

constexpr std::string_view kDegrees = "_deg";

std::optional<int> number_in(const std::string& token) {
  int number = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), number);
  if (error != std::errc{} || end != token.data() + token.size()) return std::nullopt;
  return number;
}

std::vector<std::string> tokens_of(const std::string& pointer) {
  std::vector<std::string> tokens;
  std::istringstream stream(pointer.substr(1));
  for (std::string token; std::getline(stream, token, '/');) tokens.push_back(token);
  return tokens;
}

std::string words_of(std::string key) {
  if (key.ends_with(kDegrees)) key.resize(key.size() - kDegrees.size());
  std::ranges::replace(key, '_', ' ');
  return key;
}

std::string singular(const std::string& list) {
  std::string words = words_of(list);
  if (words.ends_with('s')) words.pop_back();
  return words;
}

/// Returns the quantity of the last token, by the nearest list or object above that is known to hold it.
std::optional<Measure> measure_at(const std::vector<std::string>& tokens) {
  for (std::size_t above = tokens.size() - 1; above-- > 0;)
    if (const auto found = formats::measure_of(tokens[above], tokens.back())) return found;
  return std::nullopt;
}

/// Returns " of joint material 1", " of bedding", " of all bolts"; empty for a value of a section.
std::string owner_of(const std::vector<std::string>& tokens) {
  if (tokens.size() < 3) return {};
  const std::string &item = tokens[tokens.size() - 2], &list = tokens[tokens.size() - 3];
  if (const auto number = number_in(item)) return fmt::format(" of {} {}", singular(list), *number + 1);
  if (item == "*") return fmt::format(" of all {}", words_of(list));
  return fmt::format(" of {}", words_of(item));
}

}  // namespace

std::string label_of_key(const std::string& key, const Units& units) {
  const std::string pointer = key.starts_with(study::kOfJoints) ? key.substr(study::kOfJoints.size()) : key;
  if (!pointer.starts_with('/'))
    return with_declared(words_of(pointer), measure_of_setting(pointer).value_or(measures::kNumber), units);
  const std::vector<std::string> tokens = tokens_of(pointer);
  if (tokens.empty()) return key;
  const std::string words = words_of(tokens.back()) + owner_of(tokens);
  if (tokens.back().ends_with(kDegrees)) return words + " [deg]";
  return with_declared(words, measure_at(tokens).value_or(measures::kNumber), units);
}

std::string label_of_output(const std::string& name, const Units& units) {
  static const std::array<std::tuple<std::string_view, std::string_view, Measure>, 7> kWhole{
      {{"displacement", "largest displacement", measures::kLength},
       {"speed", "largest speed", measures::kVelocity},
       {"time", "time reached", measures::kTime},
       {"fos", "factor of safety", measures::kNumber},
       {"fos_joints", "factor of safety, joints", measures::kNumber},
       {"fos_rock", "factor of safety, rock", measures::kNumber},
       {"fos_both", "factor of safety, joints and rock", measures::kNumber}}};
  static const std::array<std::tuple<std::string_view, std::string_view, Measure>, 5> kOfPart{
      {{"dx", "displacement x", measures::kLength},
       {"dy", "displacement y", measures::kLength},
       {"vx", "velocity x", measures::kVelocity},
       {"vy", "velocity y", measures::kVelocity},
       {"r", "rotation", measures::kRadians}}};
  for (const auto& [own, words, measure] : kWhole)
    if (name == own) return with_declared(words, measure, units);
  const std::size_t dot = name.rfind('.');
  for (const auto& [own, words, measure] : kOfPart)
    if (dot != std::string::npos && name.substr(dot + 1) == own)
      return with_declared(fmt::format("{} of {}", words, name.substr(0, dot)), measure, units);
  return name;
}

}  // namespace keyblock
