// Measurements of rock in a table: two columns of numbers, and what a fit says of one number found from them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/text/csv.hpp"

namespace keyblock::study {

/// Two columns of equal length, and the line of the file of each row.
struct MeasuredPairs {
  std::string file;
  std::vector<double> x;
  std::vector<double> y;
  std::vector<int> lines;
  std::string x_unit = {};  ///< as its heading has it in brackets, "MPa" of "s3 [MPa]"; empty: none
  std::string y_unit = {};
};

/// One column, and its unit as above.
struct MeasuredColumn {
  std::vector<double> values;
  std::string unit;
};

/// The column whose heading begins with this word, upper or lower case. Throws InputError where there is none or more
/// than one, or for what is not a finite number.
MeasuredColumn read_column(const formats::CsvTable& table, std::string_view word);

/// Columns whose headings begin with these words, upper or lower case; of a table without headings the two there are.
/// Throws InputError for other columns, or for what is not a finite number.
MeasuredPairs read_pairs(const formats::CsvTable& table, std::string_view x, std::string_view y);

/// What 1 in a column of strain is: 0.01 of "%", 1e-3 of "mm/m", 1 without a unit. Throws InputError for a unit that
/// strain does not have.
double strain_factor(const MeasuredPairs& curve);

/// The unit of stress of the second column, and of the first where `both` are stresses; empty without one. Throws
/// InputError for a unit that stress does not have, or two different ones.
std::string stress_unit(const MeasuredPairs& pairs, bool both);

/// A number found by least squares. The interval holds it with a confidence of 95 % (Student's t), if the model is
/// right and errors are independent; it is infinite where as many numbers are sought as measured.
struct Found {
  double value = 0;
  double standard_error = 0;
  double low = 0;
  double high = 0;
};
Found found(double value, double standard_error, int degrees_of_freedom);

/// How well a fit agrees.
struct Agreement {
  std::vector<double> fitted;  ///< y of each pair
  double rms = 0;              ///< √(Σ r² / n)
  double largest = 0;          ///< |r|
  double r_squared = 0;        ///< 1 - Σ r² / Σ (y - mean)²
};
Agreement agreement(const std::vector<double>& measured, std::vector<double> fitted);

}  // namespace keyblock::study
