// Lists the extreme cases and lays out their table.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/extremes/extreme.hpp"

#include <fmt/format.h>

namespace keyblock::extremes {

const std::vector<ExtremeCase>& extreme_cases() {
  static const std::vector<ExtremeCase> cases{{"ext-01", mass_ratio},    {"ext-02", stiffness_ratio},
                                              {"ext-03", penalty_sweep}, {"ext-04", coordinate_offset},
                                              {"ext-05", slivers},       {"ext-06", time_steps},
                                              {"ext-07", drift},         {"ext-08", degenerate_parameters},
                                              {"ext-09", wall_at_rest},  {"ext-10", corner_on_corner}};
  return cases;
}

std::string table_head() {
  return fmt::format("{:<7} {:<62} {:>15} {:>15} {:>10}  {}\n", "case", "quantity", "expected", "got", "tolerance",
                     "verdict");
}

std::string table_row(const Extreme& row) {
  return fmt::format("{:<7} {:<62} {:>15.9g} {:>15.9g} {:>10.2g}  {}{}{}\n", row.id, row.quantity, row.expected,
                     row.got, row.tolerance, row.holds() ? "holds" : "misses", row.note.empty() ? "" : ": ", row.note);
}

}  // namespace keyblock::extremes
