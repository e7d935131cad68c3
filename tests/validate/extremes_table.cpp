// Prints the table of the extreme cases and fails if one misses its figure. Words: `brief` leaves out cases of minutes;
// ext-01 … choose among the cases.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "tests/extremes/extreme.hpp"

int main(int count, char** words) {
  using namespace keyblock::extremes;
  std::vector<std::string> chosen(words + 1, words + count);
  const bool is_brief = std::erase(chosen, "brief") > 0;
  int rows = 0;
  int misses = 0;
  fmt::print("{}", table_head());
  for (const ExtremeCase& one : extreme_cases()) {
    if (!chosen.empty() && std::ranges::find(chosen, one.id) == chosen.end()) continue;
    for (const Extreme& row : one.rows(is_brief ? Effort::brief : Effort::full)) {
      fmt::print("{}", table_row(row));
      ++rows;
      misses += row.holds() ? 0 : 1;
    }
    std::fflush(stdout);
  }
  fmt::print("{} of {} figures miss\n", misses, rows);
  return misses == 0 ? 0 : 1;
}
