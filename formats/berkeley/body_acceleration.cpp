// Reads the table of accelerations.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/body_acceleration.hpp"

#include <fmt/format.h>

#include "formats/text/csv.hpp"

namespace keyblock::formats {

TimeCurve read_body_acceleration(const Source& source) {
  const CsvTable table = read_csv(source);
  const std::size_t time = csv_column(table, "time");
  const std::size_t ax = csv_column(table, "ax");
  const std::size_t ay = csv_column(table, "ay");
  TimeCurve curve{{}, {}, {source.name}};
  for (const CsvRow& row : table.rows) {
    const double t = csv_real(table, row, time);
    if (!curve.times.empty() && !(t > curve.times.back()))
      throw InputError({source.name, row.line, row.columns[time]},
                       fmt::format("expected a time after {}, found {}", curve.times.back(), t));
    curve.times.push_back(t);
    curve.values.push_back({csv_real(table, row, ax), csv_real(table, row, ay)});
  }
  if (curve.times.empty()) throw InputError({source.name}, "expected a row time,ax,ay below the header, found none");
  return curve;
}

}  // namespace keyblock::formats
