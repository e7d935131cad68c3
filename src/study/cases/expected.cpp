// Reads expected.csv.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/cases/expected.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "formats/registry.hpp"
#include "formats/text/csv.hpp"
#include "settings/profile.hpp"
#include "study/cases/quantities.hpp"

namespace keyblock::study {
namespace {

// A number names a block, a measured point or a prescribed displacement; without one it is a quantity of the scene.
void require_quantity(const ExpectedValue& value, const Place& place) {
  const std::optional<Owner> owner = owner_of(value.quantity);
  if (!owner || (*owner == Owner::scene) == value.block.has_value())
    throw InputError(place,
                     fmt::format("expected a quantity of {}, found \"{}\"",
                                 value.block ? "a block, a measured point or a support" : "the scene", value.quantity));
}

void require_judged(const ExpectedValue& value, const Place& place) {
  std::vector<std::string> known = rule_names();
  known.insert(known.begin(), "both");
  if (std::ranges::find(known, value.judged) == known.end())
    throw InputError(
        place, fmt::format("expected judged to be one of {}, found \"{}\"", fmt::join(known, ", "), value.judged));
}

}  // namespace

std::vector<ExpectedValue> read_expected(const std::filesystem::path& file) {
  const formats::CsvTable table = formats::read_csv(formats::load(file.string()));
  const auto column = [&](const char* name) { return formats::csv_column(table, name); };
  const std::size_t quantity = column("quantity"), block = column("block"), time = column("time"),
                    value = column("value"), tolerance = column("tolerance"), reason = column("tolerance_reason"),
                    source = column("source");
  const auto optional_cell = [&](const formats::CsvRow& row, const char* name) {
    const auto place = std::ranges::find(table.header, name) - table.header.begin();
    return place < std::ssize(row.cells) ? row.cells[static_cast<std::size_t>(place)] : std::string();
  };
  std::vector<ExpectedValue> values;
  for (const formats::CsvRow& row : table.rows) {
    ExpectedValue v;
    v.quantity = row.cells[quantity];
    if (!row.cells[block].empty()) v.block = static_cast<int>(formats::csv_real(table, row, block));
    v.time = formats::csv_real(table, row, time);
    v.value = formats::csv_real(table, row, value);
    v.tolerance = formats::csv_real(table, row, tolerance);
    v.tolerance_reason = row.cells[reason];
    v.source = row.cells[source];
    if (const std::string judged = optional_cell(row, "judged"); !judged.empty()) v.judged = judged;
    v.listed_miss = optional_cell(row, "listed_miss");
    const Place place{file.string(), row.line, 1};
    require_quantity(v, place);
    require_judged(v, place);
    values.push_back(std::move(v));
  }
  return values;
}

std::vector<ExpectedValue> without_verdicts(std::vector<ExpectedValue> expected) {
  std::erase_if(expected,
                [](const ExpectedValue& e) { return e.value != 0 && e.tolerance > kVerdict * std::abs(e.value); });
  return expected;
}

}  // namespace keyblock::study
