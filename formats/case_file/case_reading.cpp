// Reads values, checks them, and reports those that violate their conditions.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/case_reading.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "base/nearest.hpp"
#include "formats/case_file/case_measures.hpp"
#include "formats/case_file/case_values.hpp"
#include "formats/text/numbers.hpp"
#include "settings/settings_table.hpp"

namespace keyblock::formats {
namespace {

// Bytes per byte of the file: an empty curve needs more memory than a reader may take for its two characters.
constexpr std::size_t kMostOfEmptyCurves = 12;

// as in Shi's samples
constexpr double kDisplacementRatioOfToday = 0.01;

// Returns the quantity of a setting; those of meshes are keys of `mesh`.
std::optional<Measure> measure_of_choice(const std::string& name) {
  constexpr std::string_view kMesh = "mesh.";
  if (name.starts_with(kMesh)) return measure_of("mesh", name.substr(kMesh.size()));
  return measure_of_setting(name);
}

bool takes(const std::string& name, const std::string& value) {
  try {
    Settings settings;
    set(settings, name, value);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

// Returns the word for a setting that takes off or on; for others the text of the file. A setting that takes any text
// takes that one too.
std::string text_of_flag(const std::string& name, bool flag) {
  const std::string text = flag ? "true" : "false";
  const std::string word = flag ? "on" : "off";
  return takes(name, word) && !takes(name, text) ? word : text;
}

// Whole numbers are written without a point, so that settings that count can read them.
std::string text_of_number(double value) {
  constexpr double kMostWhole = 1e15;  // below it a double holds every whole number
  const bool is_whole = std::abs(value) < kMostWhole && value == std::trunc(value);
  return is_whole ? fmt::format("{:.0f}", value == 0 ? 0.0 : value) : format_real(value);
}

// A setting may be a word in quotes, a number, or true and false; other pairs are words.
std::string text_of_pair(const JsonValue& value, std::string_view list, const std::string& name) {
  if (value.kind() == JsonKind::string) return std::string(value.string());
  if (list != kSettings) value.fail(fmt::format("{} of {}: a word in quotes", name, list));
  if (value.kind() == JsonKind::number) return text_of_number(value.number());
  if (value.kind() == JsonKind::yes || value.kind() == JsonKind::no)
    return text_of_flag(name, value.kind() == JsonKind::yes);
  value.fail(fmt::format("{} of {}: a word in quotes, a number, true or false", name, list));
}

}  // namespace

void CaseReading::name(std::string_view name) {
  std::string passed_over;
  text(name, passed_over);
}

Analysis CaseReading::start_of_analysis() const {
  Analysis analysis;
  if (!is_of_today_) return analysis;
  analysis.velocity_carry_over = 1;
  analysis.plane_strain = true;
  analysis.allowed_displacement_ratio = kDisplacementRatioOfToday;
  return analysis;
}

void CaseReading::flag(std::string_view name, bool& value) {
  if (!take(name)) return;
  if (value_->kind() != JsonKind::yes && value_->kind() != JsonKind::no)
    value_->fail(fmt::format("{} of {}: true or false", name, noun_));
  value = value_->kind() == JsonKind::yes;
}

void CaseReading::text(std::string_view name, std::string& value) {
  if (!take(name)) return;
  if (value_->kind() != JsonKind::string) value_->fail(fmt::format("{} of {}: a word", name, noun_));
  value = value_->string();
}

void CaseReading::name_at_end(std::string_view name, Rare<std::string>& value) {
  if (is_at_end_of_row()) return known(name);
  text(name, value.emplace());
  if (value->empty()) value_->fail(fmt::format("{} of {}: a word that is not empty", name, noun_));
}

void CaseReading::mass_by(std::string_view force, std::string_view stress, Units& units) {
  const auto unit_of = [&](std::string_view name, std::span<const std::string_view> known) {
    std::string unit;
    text(name, unit);
    if (!unit.empty() && std::ranges::find(known, unit) == known.end())
      value_->fail(fmt::format("{} of {}: one of {}", name, noun_, fmt::join(known, ", ")));
    if (!unit.empty() && !units.mass.empty())
      value_->fail(fmt::format("one of mass, {} and {} in {}: the others follow from it", force, stress, noun_));
    return unit;
  };
  if (const std::string unit = unit_of(force, kForceUnits); !unit.empty()) {
    units.mass = mass_of_force(unit, units.length, units.time);
    if (units.mass.empty()) value_->fail(fmt::format("length and time in {}, with which mass follows", noun_));
  }
  if (const std::string unit = unit_of(stress, kStressUnits); !unit.empty()) {
    units.mass = mass_of_stress(unit, units.length, units.time);
    if (units.mass.empty()) value_->fail(fmt::format("length and time in {}, with which mass follows", noun_));
  }
}

TimeCurve CaseReading::curve_of(const JsonValue& from, std::string_view name) {
  if (from.kind() != JsonKind::array) from.fail(fmt::format("{}: an array of rows time, x, y", name));
  TimeCurve curve;
  curve.place = from.place();
  for (const JsonValue item : from) {
    if (item.kind() != JsonKind::array) item.fail(fmt::format("{}: a row time, x, y", name));
    CaseReading row(item, name);
    row.real("time", curve.times.emplace_back());
    row.real("x", curve.values.emplace_back().x);
    row.real("y", curve.values.back().y);
    row.finish();
    if (curve.times.size() > 1 && curve.times.back() <= curve.times[curve.times.size() - 2])
      item.fail(fmt::format("{}: a time after the one before", name));
  }
  return curve;
}

void CaseReading::curve(std::string_view name, TimeCurve& curve) {
  if (take(name)) curve = curve_of(*value_, name);
}

void CaseReading::optional_curve(std::string_view name, std::optional<TimeCurve>& curve) {
  if (take(name)) curve = curve_of(*value_, name);
}

void CaseReading::curves(std::string_view name, std::vector<TimeCurve>& curves) {
  if (!take(name)) return;
  const std::size_t size = size_of(of_kind(JsonKind::array, name));
  if (size * sizeof(TimeCurve) > kMostOfEmptyCurves * value_->file_size())
    value_->fail(fmt::format("{} of {}: curves with rows, not {} of which almost all are empty", name, noun_, size));
  curves.reserve(size);
  for (const JsonValue item : *value_) curves.push_back(curve_of(item, name));
}

void CaseReading::pairs(std::string_view name, std::vector<std::pair<std::string, std::string>>& pairs) {
  if (!take(name)) return;
  const JsonValue from = of_kind(JsonKind::object, name);
  for (auto i = from.begin(); i != from.end(); ++i) {
    const JsonValue key = *i;
    ++i;
    const std::string setting(key.string());
    std::string value = text_of_pair(*i, name, setting);
    const Measure measure = measure_of_choice(setting).value_or(measures::kNumber);
    if (is_quantity(value) && measure != measures::kNumber)
      value = format_real(converted_at(*i, setting, measure, "a number"));
    pairs.emplace_back(setting, value);
  }
}

}  // namespace keyblock::formats
