// Checks option values. The checks of CLI11 would print the bounds of a double.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/option_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "base/nearest.hpp"

namespace keyblock {
namespace {

CLI::Validator check(const std::string& expected, bool takes_zero) {
  return {[=](std::string& text) {
            double number = 0;
            const bool is_number = CLI::detail::lexical_cast(text, number) && std::isfinite(number);
            if (is_number && (number > 0 || (takes_zero && number == 0))) return std::string();
            return fmt::format("expected {}, found \"{}\"", expected, text);
          },
          ""};
}

}  // namespace

CLI::Validator above_zero() {
  return check("a number above 0", false);
}

CLI::Validator zero_or_above() {
  return check("0 or a number above it", true);
}

CLI::Validator one_word_of(const std::vector<std::string>& words) {
  return {[words](std::string& text) { return unless_one_of(text, words); },
          fmt::format("{{{}}}", fmt::join(words, ","))};
}

}  // namespace keyblock
