// Reads measurements of rock from a table, two columns of numbers, and states the accuracy of fitted numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/text/csv.hpp"

namespace keyblock::study {

/// Two columns of equal length, and the line in the file of each row.
struct MeasuredPairs {
  std::string file;
  std::vector<double> x;
  std::vector<double> y;
  std::vector<int> lines;
  std::string x_unit = {};  ///< as in brackets in its heading, "MPa" of "s3 [MPa]"; empty: no unit
  std::string y_unit = {};
};

/// One column, and its unit as above.
struct MeasuredColumn {
  std::vector<double> values;
  std::string unit;
};

/// Returns the column whose heading begins with this word in any case. Throws InputError if there is not exactly one,
/// or for a cell that is not a finite number.
MeasuredColumn read_column(const formats::CsvTable& table, std::string_view word);

/// Returns the columns whose headings begin with these words in any case; without headings, the only two columns.
/// Throws InputError for other columns, or for a cell that is not a finite number.
MeasuredPairs read_pairs(const formats::CsvTable& table, std::string_view x, std::string_view y);

/// Returns the strain of a value 1 in its column: 0.01 for "%", 1e-3 for "mm/m", 1 without a unit. Throws InputError
/// for a unit that strain cannot have.
double strain_factor(const MeasuredPairs& curve);

/// Returns the unit of stress of the second column, and of the first if `both` are stresses; empty without one. Throws
/// InputError for a unit that stress cannot have, or two different ones.
std::string stress_unit(const MeasuredPairs& pairs, bool both);

/// Number found by least squares. The interval contains it with a confidence of 95 % (Student's t), if the model is
/// right and errors are independent. It is infinite if as many numbers are sought as measured.
struct Found {
  double value = 0;
  double standard_error = 0;
  double low = 0;
  double high = 0;
};
Found found(double value, double standard_error, int degrees_of_freedom);

/// Agreement of a fit with the measurements.
struct Agreement {
  std::vector<double> fitted;  ///< y of each pair
  double rms = 0;              ///< √(Σ r² / n)
  double largest = 0;          ///< |r|
  double r_squared = 0;        ///< 1 - Σ r² / Σ (y - mean)²
};
Agreement agreement(const std::vector<double>& measured, std::vector<double> fitted);

}  // namespace keyblock::study
