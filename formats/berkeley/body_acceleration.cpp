// Reads the table of accelerations, in the units of its headings.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/body_acceleration.hpp"

#include <fmt/format.h>

#include "base/decimals.hpp"
#include "formats/text/csv.hpp"
#include "formats/text/tokens.hpp"
#include "problem/units/unit_conversion.hpp"

namespace keyblock::formats {
namespace {

constexpr double kStandardGravity = 9.80665;  // m/s², CGPM 1901

std::optional<Unit> unit_of(const std::string& name, const Dimension& dimension) {
  if (name == "g" && dimension == kAcceleration) return Unit{kAcceleration, kStandardGravity};
  const std::optional<Unit> unit = unit_named(name);
  return unit && !unit->is_angle && unit->dimension == dimension ? unit : std::nullopt;
}

/// Column of numbers of one dimension, in the units of the case.
class Column {
 public:
  Column(const CsvTable& table, const char* name, const Dimension& dimension, const Units& units)
      : table_(table), place_(csv_column(table, name)) {
    const std::string& heading = table.header[place_];
    const std::string named = csv_heading(heading).unit;
    if (named.empty()) return;
    const std::optional<Unit> unit = unit_of(named, dimension);
    const std::optional<double> own = si_factor(units, dimension);
    if (!unit)
      refuse(dimension == kAcceleration ? "a unit of acceleration, such as m/s2 or g" : "a unit of time, such as s");
    if (!own) refuse(fmt::format("the heading \"{}\", because the case declares no units", name));
    factor_ = unit->factor / *own;
  }

  double at(const CsvRow& row) const {
    const double value = csv_real(table_, row, place_);
    return factor_ == 1 ? value : short_decimal(factor_ * value);
  }
  int column(const CsvRow& row) const { return row.columns[place_]; }

 private:
  [[noreturn]] void refuse(const std::string& expected) const {
    throw InputError({table_.name, 1, 1},
                     fmt::format("expected {}, found {}", expected, in_quotes(table_.header[place_])));
  }

  const CsvTable& table_;
  std::size_t place_;
  double factor_ = 1;  ///< from the unit of the heading to that of the case
};

}  // namespace

TimeCurve read_body_acceleration(const Source& source, const Units& units) {
  const CsvTable table = read_csv(source);
  const Column time(table, "time", kTimeDimension, units);
  const Column ax(table, "ax", kAcceleration, units);
  const Column ay(table, "ay", kAcceleration, units);
  TimeCurve curve{{}, {}, {source.name}};
  for (const CsvRow& row : table.rows) {
    const double t = time.at(row);
    if (!curve.times.empty() && !(t > curve.times.back()))
      throw InputError({source.name, row.line, time.column(row)},
                       fmt::format("expected a time after {}, found {}", curve.times.back(), t));
    curve.times.push_back(t);
    curve.values.push_back({ax.at(row), ay.at(row)});
  }
  if (curve.times.empty()) throw InputError({source.name}, "expected a row time,ax,ay below the header, found none");
  return curve;
}

}  // namespace keyblock::formats
