// Writes numbers as the shortest text that reads back the same; nlohmann's writer escapes words.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/case_writing.hpp"

#include <nlohmann/json.hpp>

#include "formats/text/numbers.hpp"

namespace keyblock::formats {

CaseWriting::CaseWriting(std::string& text, Shape shape, int depth) : text_(text), shape_(shape), depth_(depth) {
  text_ += shape_ == Shape::object ? '{' : '[';
}

void CaseWriting::finish() {
  if (shape_ == Shape::object && !is_first_) new_line(depth_);
  text_ += shape_ == Shape::object ? '}' : ']';
}

void CaseWriting::next(std::string_view name) {
  if (!std::exchange(is_first_, false)) text_ += shape_ == Shape::object ? "," : ", ";
  if (shape_ == Shape::row) return;
  new_line(depth_ + 1);
  text_ += '"';
  text_ += name;
  text_ += "\": ";
}

void CaseWriting::new_line(int depth) {
  text_ += '\n';
  text_.append(static_cast<std::size_t>(depth), ' ');
}

void CaseWriting::quote(std::string_view value) {
  text_ += nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void CaseWriting::real(std::string_view name, double value, const Demand&) {
  next(name);
  text_ += format_real(value);
}

void CaseWriting::flag(std::string_view name, bool value) {
  next(name);
  text_ += value ? "true" : "false";
}

void CaseWriting::text(std::string_view name, const std::string& value) {
  if (value.empty()) return;
  next(name);
  quote(value);
}

void CaseWriting::formula(std::string_view name, const Formula& formula) {
  next(name);
  if (is_number(formula))
    text_ += formula.text;
  else
    quote(formula.text);
}

void CaseWriting::optional_formula(std::string_view name, const std::optional<Formula>& formula) {
  if (formula) this->formula(name, *formula);
}

void CaseWriting::optional_real(std::string_view name, const std::optional<double>& value, const Demand& demand) {
  if (value) real(name, *value, demand);
}

void CaseWriting::optional_integer(std::string_view name, const std::optional<int>& value, const Demand& demand) {
  if (value) integer(name, *value, demand);
}

void CaseWriting::put_curve(const TimeCurve& curve) {
  text_ += '[';
  for (std::size_t i = 0; i < curve.times.size(); ++i) {
    if (i > 0) text_ += ", ";
    text_ += '[' + format_real(curve.times[i]) + ", " + format_real(curve.values[i].x) + ", " +
             format_real(curve.values[i].y) + ']';
  }
  text_ += ']';
}

void CaseWriting::curve(std::string_view name, const TimeCurve& curve) {
  if (curve.times.empty()) return;
  next(name);
  put_curve(curve);
}

void CaseWriting::optional_curve(std::string_view name, const std::optional<TimeCurve>& curve) {
  if (!curve) return;
  next(name);
  put_curve(*curve);
}

void CaseWriting::curves(std::string_view name, const std::vector<TimeCurve>& curves) {
  list(name, curves, std::nullopt, [](CaseWriting& to, const TimeCurve& curve) { to.put_curve(curve); });
}

void CaseWriting::pairs(std::string_view name, const std::vector<std::pair<std::string, std::string>>& pairs) {
  if (pairs.empty()) return;
  next(name);
  text_ += '{';
  bool first = true;
  for (const auto& [key, value] : pairs) {
    if (!std::exchange(first, false)) text_ += ',';
    new_line(depth_ + 2);
    quote(key);
    text_ += ": ";
    quote(value);
  }
  new_line(depth_ + 1);
  text_ += '}';
}

}  // namespace keyblock::formats
