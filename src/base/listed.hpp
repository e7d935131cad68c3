// Formats a list of numbers for messages, at most ten of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace keyblock {

/// Returns "3, 7, 12", or the first ten and the count.
template <class Number>
std::string listed(const std::vector<Number>& numbers) {
  constexpr std::size_t kMost = 10;
  const std::span shown = std::span(numbers).first(std::min(numbers.size(), kMost));
  const std::string more = numbers.size() > kMost ? fmt::format(", … ({} in all)", numbers.size()) : std::string();
  return fmt::format("{}{}", fmt::join(shown, ", "), more);
}

}  // namespace keyblock
