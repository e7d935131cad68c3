// Evaluates expressions by muParser, which no other file uses.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/formula.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <charconv>
#include <cmath>
#include <mutex>
#include <optional>

#include "problem/limits.hpp"

namespace keyblock {
namespace {

// The parser's time grows with the square of runs of operators.
constexpr std::size_t kLongest = 10000;

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// Length of the beginning of an expression that identifies it in a message.
constexpr std::size_t kMostSaid = 60;

std::string beginning_of(const std::string& text) {
  return text.size() > kMostSaid ? text.substr(0, kMostSaid) + "…" : text;
}

// The opening quote is before the first character; escapes are not counted, because an expression needs none.
Place place_in(const Formula& formula, std::size_t character) {
  Place place = formula.place;
  if (place.column > 0) place.column += 1 + static_cast<int>(character);
  return place;
}

/// Returns the place of a single "=", which would assign a value to a variable.
std::size_t assignment_in(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    const bool is_comparison = i > 0 && std::string_view("<>!=").find(text[i - 1]) != std::string_view::npos;
    if (is_comparison) continue;
    if (i + 1 < text.size() && text[i + 1] == '=') {
      ++i;
      continue;
    }
    return i;
  }
  return std::string::npos;
}

}  // namespace

struct Compiled::Expression {
  Formula formula;
  std::vector<std::string> names;
  std::vector<double> values;
  mu::Parser parser;
  std::mutex in_use;

  [[noreturn]] void refuse(std::size_t character, const std::string& found) const {
    throw InputError(place_in(formula, character),
                     fmt::format("expected a number or an expression in {}, found {}", fmt::join(names, ", "), found));
  }

  void compile() {
    if (formula.text.size() > kLongest)
      refuse(0, fmt::format("one of {} characters, more than {}", formula.text.size(), kLongest));
    if (const std::size_t at = assignment_in(formula.text); at != std::string::npos) refuse(at, "an assignment");
    for (std::size_t i = 0; i < names.size(); ++i) parser.DefineVar(names[i], &values[i]);
    try {
      parser.SetExpr(formula.text);
      parser.Eval();
    } catch (const mu::Parser::exception_type& error) {
      refuse_because(error);
    }
    if (parser.GetNumResults() != 1)
      refuse(0, fmt::format("{} values in \"{}\"", parser.GetNumResults(), beginning_of(formula.text)));
  }

  [[noreturn]] void refuse_because(const mu::Parser::exception_type& error) const {
    const int at = error.GetPos();
    const std::size_t character = at < 0 ? 0 : std::min(static_cast<std::size_t>(at), formula.text.size());
    const std::string token = error.GetToken();
    refuse(character, token.empty() ? fmt::format("\"{}\"", beginning_of(formula.text)) : fmt::format("\"{}\"", token));
  }
};

bool is_number(const Formula& formula) {
  return number_in(formula.text).has_value();
}

bool uses(const Formula& formula, const std::string& variable) {
  if (is_number(formula) || formula.text.size() > kLongest) return false;
  mu::Parser parser;
  try {
    parser.SetExpr(formula.text);
    return parser.GetUsedVar().contains(variable);
  } catch (const mu::Parser::exception_type&) {
    return false;
  }
}

Compiled::Compiled(const Formula& formula, std::span<const std::string_view> variables) {
  if (const auto number = number_in(formula.text)) {
    number_ = *number;
    if (std::abs(number_) > kGreatestQuantity)
      throw InputError(formula.place, fmt::format("expected a number from {:g} to {:g}, found {:g}", -kGreatestQuantity,
                                                  kGreatestQuantity, number_));
    return;
  }
  expression_ = std::make_shared<Expression>();
  expression_->formula = formula;
  for (const std::string_view name : variables) expression_->names.emplace_back(name);
  expression_->values.assign(variables.size(), 0);
  expression_->compile();
}

double Compiled::operator()(std::initializer_list<double> values) const {
  if (!expression_) return number_;
  const std::lock_guard alone(expression_->in_use);
  std::copy(values.begin(), values.end(), expression_->values.begin());
  const double value = expression_->parser.Eval();
  if (std::abs(value) <= kGreatestQuantity) return value;
  std::string where;
  for (std::size_t i = 0; i < expression_->names.size(); ++i)
    where += fmt::format("{}{} = {:g}", i == 0 ? "" : ", ", expression_->names[i], expression_->values[i]);
  throw InputError(expression_->formula.place, fmt::format("expected a finite value of \"{}\" at {}, found {}",
                                                           beginning_of(expression_->formula.text), where, value));
}

bool Compiled::is_zero() const {
  return !expression_ && number_ == 0;
}

}  // namespace keyblock
