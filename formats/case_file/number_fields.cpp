// Reads numbers, checks them, and reports those that violate their conditions.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/number_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/nearest.hpp"
#include "formats/case_file/case_measures.hpp"
#include "formats/text/numbers.hpp"
#include "formats/text/tokens.hpp"
#include "problem/limits.hpp"
#include "problem/units/unit_conversion.hpp"

namespace keyblock::formats {

bool NumberFields::is_quantity(std::string_view text) {
  const std::optional<Quantity> quantity = quantity_in(text);
  return quantity && unit_named(quantity->unit);
}

double NumberFields::converted_at(const JsonValue& value, std::string_view name, const std::optional<Measure>& of,
                                  std::string_view or_else) {
  const Measure measure = of.value_or(measures::kNumber);
  const auto [number, lacks_units] = converted(value.string(), measure, value.units());
  if (lacks_units)
    value.fail(fmt::format(
        "{}: a number, or the section \"units\": {{\"length\": \"m\", \"mass\": \"kg\", \"time\": \"s\"}} in the case, "
        "to whose units a value with a unit is converted",
        name));
  if (!number) value.fail(fmt::format("{}: {}, or {}", name, or_else, example_of(measure)));
  return *number;
}

std::optional<double> NumberFields::share_in(std::string_view text) {
  const std::optional<Quantity> quantity = quantity_in(text);
  if (!quantity) return std::nullopt;
  if (quantity->unit == "%") return quantity->number / 100;
  if (quantity->unit == "‰") return quantity->number / 1000;
  return std::nullopt;
}

void NumberFields::real(std::string_view name, double& value, const Demand& demand) {
  const auto fail_at = [&](const JsonValue& at, const char* kind) {
    at.fail(fmt::format("{} of {}: {}{}", name, noun_, kind, demand.wording));
  };
  if (take(name)) {
    const auto share =
        value_->kind() == JsonKind::string && takes_per_cent(noun_, name) ? share_in(value_->string()) : std::nullopt;
    if (share)
      value = *share;
    else if (value_->kind() == JsonKind::string && takes_unit(noun_, name))
      value = converted_at(*value_, name, measure_of(noun_, name), "a number");
    else if (value_->kind() != JsonKind::number)
      fail_at(*value_, !demand.whole && demand.range.is_bounded() ? "a number, " : "");
    else
      value = value_->number();
    if (!demand.holds(value)) fail_at(*value_, "");
    require_measurable(name, value);
  } else if (!demand.holds(value)) {
    if (missing_.empty()) missing_ = fmt::format("the key {} of {}: {}", name, noun_, demand.wording);
  }
}

void NumberFields::require_measurable(std::string_view name, double value) const {
  if (std::abs(value) <= std::min(kGreatestLength, kGreatestQuantity)) return;
  const double greatest = measure_of(noun_, name) == measures::kLength ? kGreatestLength : kGreatestQuantity;
  if (!(std::abs(value) <= greatest))
    value_->fail(fmt::format("{} of {}: a number from {:g} to {:g}", name, noun_, -greatest, greatest));
}

void NumberFields::index(std::string_view name, int& value) {
  constexpr Demand number{{}, "a whole number", true};
  double from_one = static_cast<double>(value) + 1;
  real(name, from_one, number);
  value = static_cast<int>(from_one - 1);
}

void NumberFields::optional_index(std::string_view name, std::optional<int>& value) {
  std::optional<int> number;
  optional_integer(name, number, kAtLeastOne);
  if (number) value = *number - 1;
}

void NumberFields::formula(std::string_view name, Formula& formula) {
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

void NumberFields::optional_formula(std::string_view name, std::optional<Formula>& formula) {
  Formula given;
  given.text.clear();
  this->formula(name, given);
  if (!given.text.empty()) formula = given;
}

void NumberFields::optional_real(std::string_view name, std::optional<double>& value, const Demand& demand) {
  if (!from_.member(name)) {
    known_.push_back(name);
    return;
  }
  real(name, value.emplace(), demand);
}

void NumberFields::optional_integer(std::string_view name, std::optional<int>& value, const Demand& demand) {
  if (!from_.member(name)) {
    known_.push_back(name);
    return;
  }
  integer(name, value.emplace(), demand);
}

}  // namespace keyblock::formats
