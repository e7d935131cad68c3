// Fills the table of prefixes row by row; three rows are enough.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace keyblock {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = a[i - 1] == b[j - 1];
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

std::string nearest(std::string_view name, const std::vector<std::string>& names) {
  const std::string* best = nullptr;
  std::size_t least = name.size() / 3 + 1;
  for (const std::string& other : names) {
    if (const std::size_t distance = edit_distance(name, other); distance < least) {
      least = distance;
      best = &other;
    }
  }
  return best ? *best : std::string();
}

std::string nearest_words(std::string_view name, const std::vector<std::string>& names) {
  const std::string found = nearest(name, names);
  return found.empty() ? found : fmt::format("; did you mean \"{}\"?", found);
}

std::string unless_one_of(std::string_view name, const std::vector<std::string>& names) {
  if (std::ranges::find(names, name) != names.end()) return {};
  return fmt::format("expected one of {}, found \"{}\"{}", fmt::join(names, ", "), name, nearest_words(name, names));
}

}  // namespace keyblock
