// Reads numbers from text and checks their range.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/setting_row.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace keyblock {
namespace {

template <class T>
std::optional<T> parse(const std::string& text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string words_for(const Range& range) {
  if (!range.is_bounded_below()) return "a number";
  if (range.is_bounded_above())
    return fmt::format("a number {} {} to {}", range.open_below ? "above" : "from", range.least, range.greatest);
  return fmt::format("a number {} {}", range.open_below ? "greater than" : "of at least", range.least);
}

double read_real(const Range& range, const std::string& name, const std::string& text) {
  const std::optional<double> value = parse<double>(text);
  const bool in_range = value && std::isfinite(*value) && range.has(*value);
  if (value && std::isfinite(*value) && std::abs(*value) > kGreatestQuantity)
    refuse_value(name, fmt::format("a number of at most {:g} in size", kGreatestQuantity), text);
  if (!in_range) refuse_value(name, words_for(range), text);
  return *value;
}

}  // namespace

void refuse_value(const std::string& name, const std::string& expected, const std::string& found,
                  const std::string& hint) {
  constexpr std::size_t kMostShown = 100;
  throw std::invalid_argument(fmt::format("setting {}: expected {}, found \"{}{}\"{}{}", name, expected,
                                          found.substr(0, kMostShown), found.size() > kMostShown ? "…" : "",
                                          hint.empty() ? "" : "; ", hint));
}

ValueText<double> real(Range range) {
  return {[](double value) { return fmt::format("{}", value); },
          [range](const std::string& name, const std::string& text) { return read_real(range, name, text); },
          {words_for(range), range}};
}

ValueText<std::optional<double>> real_or_nothing(Range range) {
  return {[](const std::optional<double>& value) { return value ? fmt::format("{}", *value) : std::string(); },
          [range](const std::string& name, const std::string& text) -> std::optional<double> {
            if (text.empty()) return std::nullopt;
            return read_real(range, name, text);
          },
          {words_for(range) + ", or nothing", range}};
}

ValueText<int> whole(int least) {
  const std::string expected = fmt::format("a whole number of at least {}", least);
  return {[](int value) { return fmt::format("{}", value); },
          [least, expected](const std::string& name, const std::string& text) {
            const std::optional<int> value = parse<int>(text);
            const bool is_too_large = !value && parse<double>(text).value_or(0) > std::numeric_limits<int>::max();
            if (is_too_large)
              refuse_value(name, fmt::format("{}, and at most {}", expected, std::numeric_limits<int>::max()), text);
            if (!value || *value < least) refuse_value(name, expected, text);
            return *value;
          },
          {expected, Range{static_cast<double>(least)}, true}};
}

ValueText<std::string> any_text() {
  return {[](const std::string& value) { return value; },
          [](const std::string&, const std::string& text) { return text; },
          {"any text"}};
}

ValueText<bool> off_or_on() {
  return one_of<bool>({{false, "off"}, {true, "on"}});
}

}  // namespace keyblock
