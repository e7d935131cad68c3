// Takes units of keys from the tables of the case file and of the settings, those of outputs from the results.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/sweep_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "api/case_values.hpp"
#include "base/printable.hpp"
#include "formats/case_file/case_meanings.hpp"
#include "formats/case_file/case_measures.hpp"
#include "formats/case_file/schema/case_titles.hpp"
#include "problem/units/measure.hpp"
#include "run/cover_settings.hpp"
#include "settings/settings_table.hpp"
#include "study/sweep/varied_key.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;
using study::SweepResult;
using study::SweepTable;

constexpr std::size_t kLongestWords = 60;

/// Returns "joint materials" for joint_materials, "dip scatter" for dip_scatter_deg.
std::string words_of(std::string name) {
  if (name.ends_with("_deg")) name.resize(name.size() - 4);
  std::ranges::replace(name, '_', ' ');
  return name;
}

/// Returns the first phrase of a meaning, without its unit and what is permitted; empty if that is long.
std::string first_phrase(std::string_view meaning) {
  std::size_t end = meaning.size();
  for (const std::string_view mark : {", ", ". ", "; ", ": ", " ["}) end = std::min(end, meaning.find(mark));
  return end > kLongestWords ? std::string() : std::string(meaning.substr(0, end));
}

/// Returns "joint material 1", "joint material bedding" or "all bolts" for a list and its item.
std::string item_words(const std::string& list, const std::string& item) {
  std::string words = words_of(list);
  if (item == "*") return "all " + words;
  if (words.ends_with('s')) words.pop_back();
  return fmt::format("{} {}", words, is_list_index(item) ? std::to_string(std::stoul(item) + 1) : item);
}

/// Place of a value: the key of the object that has it, its own key, and the list items on the way.
struct KeyPlace {
  std::string parent;
  std::string key;
  std::string items;  ///< " of bolt 2"
};

/// `concrete`: the pointer with numbers instead of names. `row_key`: of the last place, if that is one of a row.
KeyPlace place_of(const std::string& pointer, const std::string& concrete, const std::string& row_key = {}) {
  const std::vector<std::string> given = pointer_steps(pointer);
  std::vector<std::string> numbers = pointer_steps(concrete);
  if (!row_key.empty()) numbers.back() = row_key;
  KeyPlace place{"case", "", ""};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const bool is_item = i > 0 && is_list_index(numbers[i]) && i < given.size();
    if (is_item) place.items += " of " + item_words(numbers[i - 1], given[i]);
    if (is_list_index(numbers[i])) continue;
    if (!place.key.empty()) place.parent = place.key;
    place.key = numbers[i];
  }
  return place;
}

std::string unit_in(const std::optional<Measure>& measure, const Units& units) {
  return measure && is_declared(*measure, units) ? unit_of(*measure, units) : std::string();
}

SweepColumn column_of_case(const std::string& pointer, const std::string& case_text, const Units& units) {
  const std::vector<std::string> concrete = pointers_to(pointer, case_text, true);
  const KeyPlace place = place_of(pointer, concrete.front(), row_key_at(concrete.front()));
  const std::string phrase = first_phrase(formats::meaning_of(place.parent, place.key));
  return {pointer, unit_in(formats::measure_of(place.parent, place.key), units),
          (phrase.empty() ? words_of(place.key) : phrase) + place.items};
}

SweepColumn column_of_joints(const std::string& key, const Units& units) {
  constexpr std::array<std::string_view, 11> kLengths{"spacing", "trace", "gap",   "width", "height", "x",
                                                      "y",       "bench", "crest", "toe",   "base"};
  const std::string pointer = key.substr(study::kOfJoints.size());
  const KeyPlace place = place_of(pointer, pointer);
  std::optional<Measure> measure;
  if (std::ranges::find(kLengths, place.key) != kLengths.end()) measure = measures::kLength;
  if (place.key == "dip" || place.key == "angle" || place.key.ends_with("_deg")) measure = measures::kDegrees;
  return {key, unit_in(measure, units), words_of(place.key) + (place.items.empty() ? " of the joints" : place.items)};
}

SweepColumn column_of_setting(const std::string& name, const Units& units) {
  for (const SettingText& setting : list(Settings{}))
    if (setting.name == name) {
      const std::string phrase = first_phrase(setting.meaning);
      return {name, unit_in(measure_of_setting(name), units), phrase.empty() ? words_of(name) : phrase};
    }
  return {name, unit_in(measure_of_mesh_setting(name), units), words_of(name)};
}

SweepColumn column_of_key(const std::string& key, const std::string& case_text, const Units& units) {
  if (key.starts_with('/')) return column_of_case(key, case_text, units);
  return key.starts_with(study::kOfJoints) ? column_of_joints(key, units) : column_of_setting(key, units);
}

/// Gives a key whose values have units of their own that unit; none if they have several.
void take_own_unit(SweepColumn& column, const SweepTable& table) {
  std::set<std::string> units;
  for (const Json& row : table.rows)
    if (const SweptAmount amount = amount_of(row.value(column.name, Json())); std::isfinite(amount.number))
      units.insert(amount.unit.empty() ? column.unit : amount.unit);
  if (units.size() == 1) column.unit = *units.begin();
  if (units.size() > 1) column.unit.clear();
}

using Named = std::pair<std::string_view, std::string_view>;

/// Returns the words for a name; the name itself if the table lacks it.
template <std::size_t size>
std::string named(const std::array<Named, size>& table, const std::string& name) {
  const auto found = std::ranges::find(table, std::string_view(name), &Named::first);
  return found == table.end() ? words_of(name) : std::string(found->second);
}

/// Returns "measured point 1" for point1, "energy balance" for ledger.
std::string words_of_owner(const std::string& owner) {
  constexpr std::array<Named, 2> kTables{{{"ledger", "energy balance"}, {"step_table", "last step"}}};
  for (const auto& [prefix, words] : std::array<Named, 2>{{{"point", "measured point"}, {"tip", "crack tip"}}})
    if (owner.starts_with(prefix) && is_list_index(owner.substr(prefix.size())))
      return fmt::format("{} {}", words, owner.substr(prefix.size()));
  return named(kTables, owner);
}

std::string words_of_output(const std::string& name) {
  constexpr std::array<Named, 10> kWords{{{"displacement", "largest displacement"},
                                          {"speed", "largest speed at the end"},
                                          {"state", "state of motion at the end"},
                                          {"steps", "number of steps"},
                                          {"time", "time at the end"},
                                          {"blocks", "number of blocks"},
                                          {"fos", "factor of safety"},
                                          {"fos_joints", "factor of safety of the joints"},
                                          {"fos_rock", "factor of safety of the rock"},
                                          {"fos_both", "factor of safety of joints and rock"}}};
  constexpr std::array<Named, 12> kQuantities{{{"dx", "displacement x"},
                                               {"dy", "displacement y"},
                                               {"vx", "velocity x"},
                                               {"vy", "velocity y"},
                                               {"r", "rotation"},
                                               {"sxx", "stress xx"},
                                               {"syy", "stress yy"},
                                               {"sxy", "stress xy"},
                                               {"szz", "stress zz"},
                                               {"k1", "K_I"},
                                               {"k2", "K_II"},
                                               {"j", "J"}}};
  if (name.starts_with('/')) {
    const std::vector<std::string> steps = pointer_steps(name);
    return words_of(steps.back()) + (steps.size() > 1 ? ", " + words_of(steps[steps.size() - 2]) : std::string());
  }
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos) return named(kWords, name);
  return words_of_owner(name.substr(0, dot)) + ": " + named(kQuantities, name.substr(dot + 1));
}

/// Units of crack tips do not stand in their results.
SweepColumn column_of_output(const SweepTable& table, const std::string& name, const Units& units) {
  SweepColumn column{name, "", words_of_output(name)};
  for (const SweepResult& result : table.results)
    if (column.unit.empty() && result.units.contains(name)) column.unit = result.units.at(name).get<std::string>();
  const bool is_tip = name.starts_with("tip");
  if (is_tip && (name.ends_with(".k1") || name.ends_with(".k2"))) column.unit = unit_in(measures::kToughness, units);
  if (is_tip && name.ends_with(".j")) column.unit = unit_in(measures::kEnergyPerArea, units);
  if (is_tip && name.ends_with(".kink_deg")) column.unit = unit_in(measures::kDegrees, units);
  return column;
}

}  // namespace

SweptAmount amount_of(const Json& value) {
  if (value.is_number()) return {value.get<double>()};
  if (!value.is_string()) return {};
  const std::string text = value.get<std::string>();
  const std::size_t blank = text.find(' ');
  SweptAmount amount;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + std::min(blank, text.size()), amount.number);
  if (blank == std::string::npos || fault != std::errc() || end != text.data() + blank) return {};
  amount.unit = text.substr(blank + 1);
  return amount;
}

std::vector<SweepColumn> sweep_columns(const SweepTable& table, const std::string& case_text, const Units& units) {
  std::vector<SweepColumn> columns;
  for (const auto& [key, value] : table.rows.front().items()) {
    columns.push_back(column_of_key(key, case_text, units));
    take_own_unit(columns.back(), table);
  }
  columns.push_back({"verdict", "", "end of the run"});
  columns.push_back({"doubt", "", "reason for the verdict"});
  columns.push_back({"warnings", "", "codes of warnings; keyblock explain CODE tells more"});
  for (const std::string& name : table.outputs) columns.push_back(column_of_output(table, name, units));
  columns.push_back({"job", "", "folder of the run in jobs"});
  return columns;
}

std::string columns_csv(const std::vector<SweepColumn>& columns) {
  std::string text = "column,unit,meaning\n";
  for (const SweepColumn& column : columns)
    text += fmt::format("{},{},{}\n", csv_cell(column.name), csv_cell(column.unit), csv_cell(column.words));
  return text;
}

}  // namespace keyblock
