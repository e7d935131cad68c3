// Reads tables with or without headings, and applies Student's t; see measured.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/fit/measured.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "formats/text/numbers.hpp"
#include "formats/text/tokens.hpp"
#include "problem/units/unit_conversion.hpp"

namespace keyblock::study {
namespace {

constexpr double kConfidence = 0.95;

// Cells are numbers by the same test as in the rows below.
bool is_number(const std::string& cell) {
  return formats::parse_real(cell).has_value();
}

bool begins_with(const std::string& heading, std::string_view word) {
  const std::size_t from = std::min(heading.find_first_not_of(" \""), heading.size());
  if (heading.size() - from < word.size()) return false;
  return std::equal(word.begin(), word.end(), heading.begin() + static_cast<std::ptrdiff_t>(from),
                    [](char a, char b) { return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b))); });
}

std::size_t column_of(const formats::CsvTable& table, std::string_view word) {
  const auto has_word = [&](const std::string& heading) { return begins_with(heading, word); };
  const auto count = std::ranges::count_if(table.header, has_word);
  if (count != 1)
    throw InputError({table.name, 1, 1}, fmt::format("expected one column whose heading begins with \"{}\", found {}",
                                                     word, count == 0 ? "none" : fmt::format("{}", count)));
  return static_cast<std::size_t>(std::ranges::find_if(table.header, has_word) - table.header.begin());
}

bool is_known_unit(const std::string& text) {
  return text == "%" || text == "‰" || unit_named(text).has_value();
}

// Returns "MPa" from "Stress (axial) [MPa]" and from "Stress (MPa)": text in round brackets need not be a unit.
std::string unit_of(const std::string& heading) {
  const auto within = [&](char open, char close) {
    const std::size_t from = heading.rfind(open), to = heading.rfind(close);
    return from == std::string::npos || to == std::string::npos || to < from ? std::string()
                                                                             : heading.substr(from + 1, to - from - 1);
  };
  if (const std::string square = within('[', ']'); !square.empty()) return square;
  const std::string round = within('(', ')');
  return is_known_unit(round) ? round : std::string();
}

[[noreturn]] void refuse_unit(const MeasuredPairs& pairs, const char* expected, const std::string& found) {
  throw InputError({pairs.file, 1, 1}, fmt::format("expected {}, found {}", expected, formats::in_quotes(found)));
}

}  // namespace

double strain_factor(const MeasuredPairs& curve) {
  if (curve.x_unit.empty() || curve.x_unit == "-" || curve.x_unit == "1") return 1;
  if (curve.x_unit == "%") return 1e-2;
  if (curve.x_unit == "‰") return 1e-3;
  const std::optional<Unit> unit = unit_named(curve.x_unit);
  if (!unit || unit->is_angle || unit->dimension != Dimension{})
    refuse_unit(curve, "a unit of strain in the heading, such as %, mm/m or none", curve.x_unit);
  return unit->factor;
}

std::string stress_unit(const MeasuredPairs& pairs, bool both) {
  if (both && pairs.x_unit != pairs.y_unit)
    refuse_unit(pairs, "one unit of both stresses in the headings", pairs.x_unit + " and " + pairs.y_unit);
  if (pairs.y_unit.empty()) return {};
  const std::optional<Unit> unit = unit_named(pairs.y_unit);
  if (!unit || unit->dimension != kStress)
    refuse_unit(pairs, "a unit of stress in the heading, such as MPa or none", pairs.y_unit);
  return pairs.y_unit;
}

MeasuredColumn read_column(const formats::CsvTable& table, std::string_view word) {
  const std::size_t column = column_of(table, word);
  MeasuredColumn read{{}, unit_of(table.header[column])};
  for (const formats::CsvRow& row : table.rows) read.values.push_back(formats::csv_real(table, row, column));
  return read;
}

MeasuredPairs read_pairs(const formats::CsvTable& table, std::string_view x, std::string_view y) {
  formats::CsvTable rows = table;
  std::size_t x_column = 0, y_column = 1;
  if (!table.header.empty() && std::ranges::all_of(table.header, is_number)) {
    if (table.header.size() != 2)
      throw InputError({table.name, 1, 1}, fmt::format("expected two columns, {} and {}, or headings; found {} columns",
                                                       x, y, table.header.size()));
    std::vector<int> columns{1, static_cast<int>(table.header[0].size()) + 2};
    rows.rows.insert(rows.rows.begin(), {table.header, 1, std::move(columns)});
  } else {
    x_column = column_of(table, x);
    y_column = column_of(table, y);
  }
  MeasuredPairs pairs{table.name, {}, {}, {}};
  pairs.x_unit = unit_of(table.header[x_column]);
  pairs.y_unit = unit_of(table.header[y_column]);
  for (const formats::CsvRow& row : rows.rows) {
    pairs.x.push_back(formats::csv_real(rows, row, x_column));
    pairs.y.push_back(formats::csv_real(rows, row, y_column));
    pairs.lines.push_back(row.line);
  }
  return pairs;
}

Found found(double value, double standard_error, int degrees_of_freedom) {
  if (degrees_of_freedom < 1) {
    const double infinite = std::numeric_limits<double>::infinity();
    return {value, infinite, -infinite, infinite};
  }
  const double reach = gsl_cdf_tdist_Pinv((1 + kConfidence) / 2, degrees_of_freedom) * standard_error;
  return {value, standard_error, value - reach, value + reach};
}

Agreement agreement(const std::vector<double>& measured, std::vector<double> fitted) {
  Agreement a;
  const auto count = static_cast<double>(measured.size());
  const double mean = std::accumulate(measured.begin(), measured.end(), 0.0) / count;
  double left = 0, all = 0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const double residual = measured[i] - fitted[i];
    left += residual * residual;
    all += (measured[i] - mean) * (measured[i] - mean);
    a.largest = std::max(a.largest, std::abs(residual));
  }
  a.rms = std::sqrt(left / count);
  a.r_squared = all > 0 ? 1 - left / all : left > 0 ? 0 : 1;  // equal values leave nothing to explain
  a.fitted = std::move(fitted);
  return a;
}

}  // namespace keyblock::study
