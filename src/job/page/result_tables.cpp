// Turns tables into curves; those with a row for each thing and step become a column for each thing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/page/result_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/registry.hpp"
#include "formats/text/csv.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using formats::CsvHeading;
using formats::CsvRow;
using formats::CsvTable;
using report::PageColumn;
using report::PageRows;

std::optional<CsvTable> table_in(const fs::path& folder, std::string_view name) {
  const fs::path file = folder / name;
  if (!fs::is_regular_file(file)) return std::nullopt;
  CsvTable table = formats::read_csv(formats::load(file.string()));
  if (table.rows.empty()) return std::nullopt;
  return table;
}

/// Splits "x1 [m]".
CsvHeading heading_of(const std::string& text, bool has_units) {
  CsvHeading heading = formats::csv_heading(text);
  if (!has_units) heading.unit.clear();
  return heading;
}

/// Returns the number in a cell; NaN if it holds none.
double number_in(const std::string& cell) {
  double number = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  return error == std::errc() && end == cell.data() + cell.size() && std::isfinite(number) ? number : NAN;
}

/// Indices of the rows that stay: at most `kMostTableRows`, the last one among them.
std::vector<std::size_t> kept_rows(std::size_t count) {
  const std::size_t every = (count + kMostTableRows - 2) / (kMostTableRows - 1);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < count; i += std::max<std::size_t>(every, 1)) kept.push_back(i);
  if (count > 0 && kept.back() != count - 1) kept.push_back(count - 1);
  return kept;
}

/// Nine digits are half as long as all.
Json json_of(double number) {
  return std::isfinite(number) ? Json(std::strtod(fmt::format("{:.9g}", number).c_str(), nullptr)) : Json();
}

struct Curve {
  CsvHeading heading;
  std::vector<double> values;
};

Json curves_json(std::string_view file, std::string_view title, const std::vector<Curve>& curves) {
  Json columns = Json::array();
  const std::vector<std::size_t> kept = kept_rows(curves.front().values.size());
  for (const Curve& curve : curves) {
    Json values = Json::array();
    for (const std::size_t row : kept) values.push_back(json_of(curve.values[row]));
    columns.push_back({{"name", curve.heading.name}, {"unit", curve.heading.unit}, {"values", std::move(values)}});
  }
  return {{"name", file}, {"title", title}, {"columns", std::move(columns)}};
}

/// Curves of a table that has a row for each step.
std::vector<Curve> wide(const CsvTable& table, bool has_units) {
  std::vector<Curve> curves;
  for (std::size_t c = 0; c < table.header.size(); ++c) {
    curves.push_back({heading_of(table.header[c], has_units), {}});
    for (const CsvRow& row : table.rows) curves.back().values.push_back(number_in(row.cells[c]));
  }
  return curves;
}

/// Curves of a table that has a row for each thing and step.
class LongTable {
 public:
  LongTable(const CsvTable& table, bool has_units) : has_units_(has_units), step_(formats::csv_column(table, "step")) {
    const std::size_t time = formats::csv_column(table, "time");
    curves_.push_back({{"step", {}}, {}});
    curves_.push_back({heading_of(table.header[time], has_units), {}});
    for (const CsvRow& row : table.rows)
      if (rows_.emplace(number_in(row.cells[step_]), rows_.size()).second) {
        curves_[0].values.push_back(number_in(row.cells[step_]));
        curves_[1].values.push_back(number_in(row.cells[time]));
      }
  }

  /// Adds the number in a cell of a row to the curve of this name.
  void add(const std::string& name, const std::string& unit, const CsvRow& row, std::size_t column) {
    const auto [found, is_new] = places_.emplace(name, curves_.size());
    if (is_new) curves_.push_back({{name, has_units_ ? unit : std::string()}, std::vector<double>(rows_.size(), NAN)});
    curves_[found->second].values[rows_.at(number_in(row.cells[step_]))] = number_in(row.cells[column]);
  }

  std::vector<Curve> curves() && { return std::move(curves_); }

 private:
  bool has_units_;
  std::size_t step_;
  std::vector<Curve> curves_;
  std::map<std::string, std::size_t> places_;
  std::map<double, std::size_t> rows_;  ///< by step
};

/// Returns "displacement x" for "displacement_x".
std::string words_of(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

std::vector<Curve> histories(const CsvTable& table, bool has_units) {
  LongTable curves(table, has_units);
  const std::size_t what = formats::csv_column(table, "what"), name = formats::csv_column(table, "name"),
                    quantity = formats::csv_column(table, "quantity"), value = formats::csv_column(table, "value"),
                    unit = formats::csv_column(table, "unit");
  for (const CsvRow& row : table.rows)
    curves.add(fmt::format("{} {}, {}", row.cells[what], row.cells[name], words_of(row.cells[quantity])),
               row.cells[unit], row, value);
  return std::move(curves).curves();
}

/// Curves of the columns `shown` of each thing; `name` names the thing of a row.
template <class Name>
std::vector<Curve> by_thing(const CsvTable& table, bool has_units, const std::vector<std::string_view>& shown,
                            const Name& name) {
  LongTable curves(table, has_units);
  for (const std::string_view column : shown) {
    const std::size_t c = formats::csv_column(table, column);
    for (const CsvRow& row : table.rows)
      curves.add(fmt::format("{}, {}", name(row), column), heading_of(table.header[c], true).unit, row, c);
  }
  return std::move(curves).curves();
}

/// Columns of the energy balance that are no energies.
bool is_of_momentum(std::string_view name) {
  return name.find("momentum") != std::string_view::npos || name.find("impulse") != std::string_view::npos;
}

std::string tip_name(const CsvTable& table, const CsvRow& row) {
  return fmt::format("crack {}, {}", row.cells[formats::csv_column(table, "crack")],
                     row.cells[formats::csv_column(table, "end")] == "2" ? "last point" : "first point");
}

/// Column of a part in time, from columns of its table.
struct PartColumn {
  PageColumn column;  ///< its unit is that of the first table column
  std::vector<std::string_view> from;
};

RowsByStep rows_by_step(const CsvTable& table, std::string_view name, const std::vector<PartColumn>& columns,
                        bool has_units) {
  RowsByStep found;
  const std::size_t step = formats::csv_column(table, "step");
  for (const CsvRow& row : table.rows) {
    PageRows& rows = found[static_cast<int>(number_in(row.cells[step]))];
    if (rows.count == 0) rows.name = name;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (rows.count == 0) rows.columns.push_back(columns[k].column);
      for (const std::string_view from : columns[k].from) {
        const std::size_t c = formats::csv_column(table, from);
        rows.columns[k].numbers.push_back(number_in(row.cells[c]));
        if (rows.count == 0) rows.columns[k].unit = heading_of(table.header[c], has_units).unit;
      }
    }
    ++rows.count;
  }
  return found;
}

}  // namespace

Json result_tables(const fs::path& folder, bool has_units) {
  struct Wide {
    std::string_view file, title;
  };
  constexpr std::array kWide{Wide{"history.csv", "Measured points and bolts"}, Wide{"ledger.csv", "Energy balance"},
                             Wide{"step_table.csv", "Steps of the solver"}};
  Json tables = Json::array();
  if (const auto table = table_in(folder, "histories.csv"))
    tables.push_back(curves_json("histories.csv", "Histories", histories(*table, has_units)));
  for (const auto& [file, title] : kWide)
    if (const auto table = table_in(folder, file)) {
      std::vector<Curve> curves = wide(*table, has_units);
      std::erase_if(curves, [](const Curve& c) { return is_of_momentum(c.heading.name); });
      tables.push_back(curves_json(file, title, curves));
    }
  if (const auto table = table_in(folder, "points.csv"))
    tables.push_back(curves_json("points.csv", "Stress at measured points",
                                 by_thing(*table, has_units, {"sxx", "syy", "sxy", "szz"}, [&](const CsvRow& row) {
                                   return "point " + row.cells[formats::csv_column(*table, "point")];
                                 })));
  if (const auto table = table_in(folder, "tips.csv"))
    tables.push_back(curves_json("tips.csv", "Stress intensity at crack tips",
                                 by_thing(*table, has_units, {"K_I", "K_II", "J", "K_eq", "length"},
                                          [&](const CsvRow& row) { return tip_name(*table, row); })));
  return tables;
}

RowsByStep points_by_step(const fs::path& folder, bool has_units) {
  const auto table = table_in(folder, "points.csv");
  if (!table) return {};
  return rows_by_step(*table, "points",
                      {{{"point", "", 1, true}, {"point"}},
                       {{"place", "", 2, false, true}, {"x", "y"}},
                       {{"displacement", "", 2}, {"dx", "dy"}},
                       {{"stress", "", 4}, {"sxx", "syy", "sxy", "szz"}}},
                      has_units);
}

RowsByStep tips_by_step(const fs::path& folder, bool has_units) {
  const auto table = table_in(folder, "tips.csv");
  if (!table) return {};
  return rows_by_step(*table, "tips",
                      {{{"tip", "", 1, true}, {"tip"}},
                       {{"crack", "", 1, true}, {"crack"}},
                       {{"end", "", 1, true}, {"end"}},
                       {{"place", "", 2, false, true}, {"x", "y"}},
                       {{"length", "", 1}, {"length"}},
                       {{"K_I", "", 1}, {"K_I"}},
                       {{"K_II", "", 1}, {"K_II"}},
                       {{"J", "", 1}, {"J"}}},
                      has_units);
}

std::map<int, double> load_factors(const fs::path& folder) {
  std::map<int, double> found;
  for (const auto& [file, column] : {std::pair("tips.csv", "load_factor"), std::pair("history.csv", "load_share")}) {
    const auto table = table_in(folder, file);
    if (!table || std::ranges::find(table->header, column) == table->header.end()) continue;
    const std::size_t step = formats::csv_column(*table, "step"), factor = formats::csv_column(*table, column);
    for (const CsvRow& row : table->rows)
      if (const double value = number_in(row.cells[factor]); std::isfinite(value))
        found[static_cast<int>(number_in(row.cells[step]))] = value;
    break;
  }
  return found;
}

}  // namespace keyblock
