// Finds each name in history.csv, ledger.csv or histories.csv, in this order.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/handout/recorded_curves.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "base/bytes/file_bytes.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"
#include "formats/text/csv.hpp"
#include "report/drawing/chart.hpp"
#include "report/page.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;

constexpr double kChartHeight = 330;
constexpr double kHighest = 0.7;  // of a narrow chart, over its width
constexpr std::size_t kMostNamed = 30;
constexpr std::array<const char*, 2> kWideTables{"history.csv", "ledger.csv"};
constexpr const char* kLongTable = "histories.csv";

/// Values by step; a step without a value is left out.
struct Recorded {
  std::string unit;
  std::map<int, double> values;
};

std::optional<formats::CsvTable> table_in(const fs::path& folder, const char* name) {
  const fs::path file = folder / name;
  if (!fs::is_regular_file(file)) return std::nullopt;
  return formats::read_csv({file.string(), file_bytes(file.string())});
}

std::string name_of(const formats::CsvTable& table, const formats::CsvRow& row) {
  const auto cell = [&](const char* column) { return row.cells[formats::csv_column(table, column)]; };
  const std::string name = cell("name");
  const bool is_number = !name.empty() && std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; });
  return fmt::format("{}{}.{}", is_number ? cell("what") + " " : "", name, cell("quantity"));
}

void add(Recorded& into, const formats::CsvTable& table, const formats::CsvRow& row, std::size_t column) {
  if (row.cells[column].empty()) return;
  const auto step = static_cast<int>(formats::csv_real(table, row, formats::csv_column(table, "step")));
  into.values[step] = formats::csv_real(table, row, column);
}

std::optional<Recorded> of_wide(const formats::CsvTable& table, const std::string& name) {
  for (std::size_t column = 0; column < table.header.size(); ++column) {
    const auto [own, unit] = formats::csv_heading(table.header[column]);
    if (own != name) continue;
    Recorded found{unit, {}};
    for (const formats::CsvRow& row : table.rows) add(found, table, row, column);
    return found;
  }
  return std::nullopt;
}

std::optional<Recorded> of_long(const formats::CsvTable& table, const std::string& name) {
  Recorded found;
  for (const formats::CsvRow& row : table.rows) {
    if (name_of(table, row) != name) continue;
    found.unit = row.cells[formats::csv_column(table, "unit")];
    add(found, table, row, formats::csv_column(table, "value"));
  }
  if (found.values.empty()) return std::nullopt;
  return found;
}

Recorded recorded(const fs::path& folder, const std::string& name) {
  for (const char* wide : kWideTables)
    if (const auto table = table_in(folder, wide))
      if (auto found = of_wide(*table, name)) return *std::move(found);
  if (const auto table = table_in(folder, kLongTable))
    if (auto found = of_long(*table, name)) return *std::move(found);
  std::vector<std::string> names = recorded_names(folder);
  const std::string near = nearest_words(name, names);
  const std::size_t all = names.size();
  names.resize(std::min(names.size(), kMostNamed));
  throw UsageError(fmt::format("there is no curve \"{}\" in {}{}; there are {}{}", name, folder.string(), near,
                               fmt::join(names, ", "), all > names.size() ? ", …" : ""));
}

// Returns the quantity of an axis; values with the unit of a known measure are drawn in a readable unit.
report::Described axis_of(const std::string& words, const std::string& unit, const Units& units) {
  for (const Measure& measure : {measures::kLength, measures::kTime, measures::kStress, measures::kForce,
                                 measures::kEnergy, measures::kVelocity, measures::kMoment, measures::kMomentum})
    if (!unit.empty() && is_declared(measure, units) && keyblock::unit_of(measure, units) == unit)
      return {words, measure, units};
  return unit.empty() ? words : fmt::format("{} [{}]", words, unit);
}

}  // namespace

std::vector<std::string> recorded_names(const fs::path& folder) {
  std::vector<std::string> names;
  const auto put = [&](const std::string& name) {
    if (name != "step" && std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (const char* wide : kWideTables)
    if (const auto table = table_in(folder, wide))
      for (const std::string& heading : table->header) put(formats::csv_heading(heading).name);
  if (const auto table = table_in(folder, kLongTable))
    for (const formats::CsvRow& row : table->rows) {
      const std::string name = name_of(*table, row);
      if (std::ranges::find(names, name) != names.end()) break;  // the first step has all of them
      put(name);
    }
  return names;
}

std::string recorded_picture(const fs::path& folder, const CurveRequest& request, const std::string& title,
                             const Units& units, double wide) {
  const Recorded across = recorded(folder, request.against);
  std::vector<report::Curve> curves;
  std::optional<std::string> unit;
  for (const std::string& name : request.names) {
    const Recorded found = recorded(folder, name);
    if (unit && *unit != found.unit)
      throw UsageError(
          fmt::format("--curve: expected curves of one unit, found {} [{}] beside [{}]", name, found.unit, *unit));
    unit = found.unit;
    report::Curve& curve = curves.emplace_back(report::Curve{name, {}, {}});
    for (const auto& [step, value] : found.values)
      if (const auto x = across.values.find(step); x != across.values.end()) {
        curve.x.push_back(x->second);
        curve.y.push_back(value);
      }
  }
  const double top = report::kMargin + (title.empty() ? 0 : report::kTitleHeight);
  const double high = std::min(kChartHeight, kHighest * wide);
  report::SvgPage page(wide, top + high + report::kMargin);
  if (!title.empty()) page.text({report::kMargin, report::kMargin}, title, {.size = 17, .bold = true});
  if (report::has_points(curves))
    report::draw_chart(
        page, {report::kMargin, top}, {wide - 2 * report::kMargin, high}, curves,
        {axis_of(request.against, across.unit, units),
         axis_of(request.names.size() == 1 ? request.names.front() : "value", unit.value_or(""), units)});
  return page.str();
}

}  // namespace keyblock
