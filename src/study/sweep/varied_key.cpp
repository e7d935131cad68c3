// Splits at commas outside brackets and quotes. The inverse of the normal distribution is Newton's method on erfc.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/sweep/varied_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace keyblock::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostOfRange = 100'000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(' ') - first + 1));
}

/// Number at the beginning of a text, and the rest of it: a unit, or nothing. Refuses formulas such as 2*t, and words
/// such as 1..2.
struct Amount {
  double number = 0;
  std::string unit;
};

std::optional<Amount> amount_of(const std::string& text) {
  Amount amount;
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto [end, fault] = std::from_chars(begin, text.data() + text.size(), amount.number);
  if (fault != std::errc() || !std::isfinite(amount.number)) return std::nullopt;
  amount.unit = trimmed({end, text.data() + text.size()});
  constexpr std::string_view kBeginNoUnit = "+-*/^(.:";
  if (!amount.unit.empty() && kBeginNoUnit.find(amount.unit.front()) != std::string_view::npos) return std::nullopt;
  return amount;
}

/// Splits at `separator` outside brackets and double quotes.
std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts(1);
  int depth = 0;
  bool is_quoted = false;
  for (const char c : text) {
    if (c == '"') is_quoted = !is_quoted;
    if (!is_quoted && (c == '[' || c == '{' || c == '(')) ++depth;
    if (!is_quoted && (c == ']' || c == '}' || c == ')')) --depth;
    if (c == separator && depth == 0 && !is_quoted)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  for (std::string& part : parts) part = trimmed(part);
  return parts;
}

Json json_of(double number, const std::string& unit) {
  const Json json = number_json(number);
  return unit.empty() ? json : Json(fmt::format("{} {}", json.dump(), unit));
}

Json json_of(const std::string& word) {
  Json json = Json::parse(word, nullptr, false);
  return json.is_discarded() ? Json(word) : json;
}

std::vector<Json> list_of(const std::vector<std::string>& words, WordKind kind) {
  const std::optional<Amount> last = amount_of(words.back());
  const auto is_amount = [](const std::string& word) { return amount_of(word).has_value(); };
  const bool are_amounts = kind == WordKind::amount && std::ranges::all_of(words, is_amount);
  std::vector<Json> values;
  for (const std::string& word : words) {
    if (kind == WordKind::name && !word.starts_with('"')) {
      values.emplace_back(word);
      continue;
    }
    if (!are_amounts || last->unit.empty()) {
      values.push_back(json_of(word));
      continue;
    }
    const Amount amount = *amount_of(word);
    values.push_back(json_of(amount.number, amount.unit.empty() ? last->unit : amount.unit));
  }
  return values;
}

/// Returns the values of FIRST:LAST:STEP; nothing if the text is not of this form. Throws std::invalid_argument for a
/// step that leads nowhere, and for too many values.
std::optional<std::vector<Json>> range_of(const std::string& text) {
  const std::vector<std::string> parts = split(text, ':');
  if (parts.size() != 3) return std::nullopt;
  std::array<Amount, 3> amounts;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<Amount> amount = amount_of(parts[i]);
    if (!amount || (i < 2 && !amount->unit.empty())) return std::nullopt;
    amounts[i] = *amount;
  }
  const double first = amounts[0].number, last = amounts[1].number, step = amounts[2].number;
  const double count = std::floor((last - first) / step + 1e-9);  // round-off of decimal steps
  if (!(count >= 0) || count >= kMostOfRange)
    throw std::invalid_argument(fmt::format(
        "expected FIRST:LAST:STEP with a step that leads from FIRST to LAST in at most {} values, found \"{}\"",
        kMostOfRange, text));
  std::vector<Json> values;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(count); ++i) {
    const double value = first + static_cast<double>(i) * step;
    values.push_back(json_of(std::stod(fmt::format("{:.15g}", value)), amounts[2].unit));
  }
  return values;
}

bool is_sound(const Distribution& d) {
  const std::vector<double>& n = d.numbers;
  switch (d.law) {
    case Law::normal:
      return (n.size() == 2 || (n.size() == 4 && n[2] < n[3])) && n[1] > 0;
    case Law::lognormal:
      return n.size() == 2 && n[0] > 0 && n[1] > 0;
    case Law::uniform:
      return n.size() == 2 && n[0] < n[1];
    case Law::triangular:
      return n.size() == 3 && n[0] <= n[1] && n[1] <= n[2] && n[0] < n[2];
  }
  return false;
}

std::optional<Distribution> distribution_of(const std::string& text) {
  constexpr std::array<std::pair<std::string_view, Law>, 4> kLaws{{{"normal(", Law::normal},
                                                                   {"lognormal(", Law::lognormal},
                                                                   {"uniform(", Law::uniform},
                                                                   {"triangular(", Law::triangular}}};
  const auto found = std::ranges::find_if(kLaws, [&](const auto& law) { return text.starts_with(law.first); });
  const std::size_t close = text.find(')');
  if (found == kLaws.end() || close == std::string::npos) return std::nullopt;
  Distribution distribution{found->second, {}, trimmed(std::string_view(text).substr(close + 1))};
  const std::size_t open = found->first.size();
  for (const std::string& word : split(std::string_view(text).substr(open, close - open), ',')) {
    const std::optional<Amount> amount = amount_of(word);
    if (!amount || !amount->unit.empty()) return std::nullopt;
    distribution.numbers.push_back(amount->number);
  }
  return is_sound(distribution) ? std::optional(distribution) : std::nullopt;
}

double below_normal(double x) {
  return 0.5 * std::erfc(-x / std::numbers::sqrt2);
}

// Bisection keeps Newton's method inside; the tails are symmetric, so that small fractions keep their digits.
double standard_normal(double p) {
  if (p > 0.5) return -standard_normal(1 - p);
  double low = -40, high = 0.1, x = -1;
  for (int i = 0; i < 200; ++i) {
    const double excess = below_normal(x) - p;
    (excess > 0 ? high : low) = x;
    const double density = std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi);
    const double next = x - excess / density;
    const double inside = next > low && next < high ? next : (low + high) / 2;
    if (std::abs(inside - x) <= 1e-15 * std::abs(x)) return inside;
    x = inside;
  }
  return x;
}

/// Returns the logarithm of `below_normal`, also where that is too small for a number. There it is the asymptotic
/// series of Mills ratio, whose error is below 2e-10.
double log_below_normal(double x) {
  constexpr double kSeriesFrom = -30;
  if (x > kSeriesFrom) return std::log(below_normal(x));
  const double r = 1 / (x * x);
  return -x * x / 2 - std::log(-x * std::sqrt(2 * std::numbers::pi)) + std::log1p(r * (-1 + r * (3 - 15 * r)));
}

/// Returns the quantile of the standard normal distribution between two bounds below the mean. Logarithms keep the
/// digits of probabilities that a number cannot hold.
double quantile_in_tail(double low, double high, double p) {
  const double last = log_below_normal(high);
  const double first = low > -1e150 ? std::exp(log_below_normal(low) - last) : 0;
  const double wanted = last + std::log(first + (1 - first) * p);
  double below = std::max(low, high - 1e10), above = high;
  for (int i = 0; i < 200 && below < above; ++i) {
    const double middle = (below + above) / 2;
    if (middle <= below || middle >= above) break;
    (log_below_normal(middle) > wanted ? above : below) = middle;
  }
  return (below + above) / 2;
}

/// Returns the quantile of the standard normal distribution between two bounds.
double between(double low, double high, double p) {
  constexpr double kTail = 4;  // deviations, from which a difference of probabilities loses digits
  if (high < -kTail) return quantile_in_tail(low, high, p);
  if (low > kTail) return -quantile_in_tail(-high, -low, 1 - p);
  const double first = below_normal(low), last = below_normal(high);
  return standard_normal(std::clamp(first + (last - first) * p, 1e-300, 1 - 1e-16));
}

}  // namespace

Json number_json(double number) {
  constexpr double kLargestExact = 9007199254740992;  // 2^53
  const bool is_whole = number == std::floor(number) && std::abs(number) <= kLargestExact;
  return is_whole ? Json(static_cast<long long>(number)) : Json(number);
}

double Distribution::quantile(double p) const {
  const std::vector<double>& n = numbers;
  switch (law) {
    case Law::normal: {
      if (n.size() == 2) return n[0] + n[1] * between(-kInfinity, kInfinity, p);
      return std::clamp(n[0] + n[1] * between((n[2] - n[0]) / n[1], (n[3] - n[0]) / n[1], p), n[2], n[3]);
    }
    case Law::lognormal: {
      const double variance = std::log1p((n[1] / n[0]) * (n[1] / n[0]));
      return std::exp(std::log(n[0]) - variance / 2 + std::sqrt(variance) * standard_normal(p));
    }
    case Law::uniform:
      return n[0] + (n[1] - n[0]) * p;
    case Law::triangular: {
      const double rise = (n[1] - n[0]) / (n[2] - n[0]);
      if (p < rise) return n[0] + std::sqrt(p * (n[2] - n[0]) * (n[1] - n[0]));
      return n[2] - std::sqrt((1 - p) * (n[2] - n[0]) * (n[2] - n[1]));
    }
  }
  return 0;
}

VariedKey varied_key_of(const std::string& text, const std::function<WordKind(const std::string& key)>& words_of) {
  const std::size_t equals = text.find('=');
  const std::string key = trimmed(text.substr(0, equals));
  const std::string values = equals == std::string::npos ? "" : trimmed(std::string_view(text).substr(equals + 1));
  const auto refuse = [&](const char* expected) {
    throw std::invalid_argument(fmt::format("expected {}, found \"{}\"", expected, text));
  };
  if (key.empty() || values.empty())
    refuse("KEY=VALUES, such as /analysis/joint_materials/bedding/friction_angle_deg=20:40:2");
  VariedKey varied{key};
  const WordKind kind = words_of ? words_of(key) : WordKind::amount;
  if (kind != WordKind::name) {
    varied.distribution = distribution_of(values);
    if (varied.distribution) return varied;
    for (const char* law : {"normal(", "lognormal(", "uniform(", "triangular("})
      if (values.starts_with(law))
        refuse(
            "normal(MEAN,DEVIATION), normal(MEAN,DEVIATION,LOW,HIGH), lognormal(MEAN,DEVIATION), uniform(LOW,HIGH) or "
            "triangular(LOW,MODE,HIGH)");
    if (auto range = range_of(values)) {
      varied.values = *std::move(range);
      return varied;
    }
  }
  const std::vector<std::string> words = split(values, ',');
  if (std::ranges::any_of(words, [](const std::string& word) { return word.empty(); }))
    refuse("values separated by commas");
  varied.values = list_of(words, kind);
  if (std::ranges::any_of(varied.values, &Json::is_null)) refuse("values other than null, which only designs have");
  return varied;
}

}  // namespace keyblock::study
