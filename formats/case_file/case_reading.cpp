// Values with the demands they must meet, and the complaints about those that do not.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/case_reading.hpp"

#include <cmath>

#include "base/nearest.hpp"
#include "formats/case_file/case_measures.hpp"
#include "formats/text/numbers.hpp"
#include "settings/settings_table.hpp"

namespace keyblock::formats {
namespace {

// Bytes a byte of the file: an empty curve takes more than a reader may hold of the two characters it stands in.
constexpr std::size_t kMostOfEmptyCurves = 12;

// As Shi's samples have it.
constexpr double kDisplacementRatioOfToday = 0.01;

// A number and the name of a unit, which no expression is: x, y and functions are none.
bool is_quantity(std::string_view text) {
  const std::optional<Quantity> quantity = quantity_in(text);
  return quantity && unit_named(quantity->unit);
}

// The number that a text stands for, in the units of the case; `or_else`: what else may stand there.
double converted_at(const JsonValue& value, std::string_view name, const std::optional<Measure>& of,
                    std::string_view or_else) {
  const Measure measure = of.value_or(measures::kNumber);
  const auto [number, lacks_units] = converted(value.string(), measure, value.units());
  if (lacks_units)
    value.fail(fmt::format(
        "{}: units of the case (\"units\": {{\"length\": \"m\", …}}), into which a value is converted", name));
  if (!number) value.fail(fmt::format("{}: {}, or {}", name, or_else, example_of(measure)));
  return *number;
}

// What a setting measures; those of meshes are the keys of `mesh`.
std::optional<Measure> measure_of_choice(const std::string& name) {
  constexpr std::string_view kMesh = "mesh.";
  if (name.starts_with(kMesh)) return measure_of("mesh", name.substr(kMesh.size()));
  return measure_of_setting(name);
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

void CaseReading::real(std::string_view name, double& value, const Demand& demand) {
  const auto fail_at = [&](const JsonValue& at) { at.fail(fmt::format("{} of {}: {}", name, noun_, demand.wording)); };
  if (take(name)) {
    if (value_->kind() == JsonKind::string && takes_unit(noun_, name))
      value = converted_at(*value_, name, measure_of(noun_, name), "a number");
    else if (value_->kind() != JsonKind::number)
      fail_at(*value_);
    else
      value = value_->number();
    if (!demand.holds(value)) fail_at(*value_);
  } else if (!demand.holds(value)) {
    if (missing_.empty()) missing_ = fmt::format("the key {} of {}: {}", name, noun_, demand.wording);
  }
}

void CaseReading::index(std::string_view name, int& value) {
  constexpr Demand number{[](double v) { return is_whole(v) && std::abs(v) <= std::numeric_limits<int>::max(); },
                          "a whole number"};
  double from_one = static_cast<double>(value) + 1;
  real(name, from_one, number);
  value = static_cast<int>(from_one - 1);
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

void CaseReading::formula(std::string_view name, Formula& formula) {
  if (!take(name)) return;
  if (value_->kind() != JsonKind::number && value_->kind() != JsonKind::string)
    value_->fail(fmt::format("{} of {}: a number or an expression in quotes", name, noun_));
  formula.place = value_->place();
  if (value_->kind() == JsonKind::number)
    formula.text = format_real(value_->number());
  else if (is_quantity(value_->string()) && takes_unit(noun_, name))
    formula.text = format_real(converted_at(*value_, name, measure_of(noun_, name), "a number, an expression"));
  else
    formula.text = value_->string();
}

void CaseReading::optional_formula(std::string_view name, std::optional<Formula>& formula) {
  Formula given;
  given.text.clear();
  this->formula(name, given);
  if (!given.text.empty()) formula = given;
}

void CaseReading::optional_real(std::string_view name, std::optional<double>& value, const Demand& demand) {
  if (!from_.member(name)) {
    known_.push_back(name);
    return;
  }
  real(name, value.emplace(), demand);
}

void CaseReading::optional_integer(std::string_view name, std::optional<int>& value, const Demand& demand) {
  if (!from_.member(name)) {
    known_.push_back(name);
    return;
  }
  integer(name, value.emplace(), demand);
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
    if ((*i).kind() != JsonKind::string) (*i).fail(fmt::format("{} of {}: a word in quotes", key.string(), name));
    const std::string setting(key.string());
    std::string value((*i).string());
    const Measure measure = measure_of_choice(setting).value_or(measures::kNumber);
    if (is_quantity(value) && measure != measures::kNumber)
      value = format_real(converted_at(*i, setting, measure, "a number"));
    pairs.emplace_back(setting, value);
  }
}

}  // namespace keyblock::formats
