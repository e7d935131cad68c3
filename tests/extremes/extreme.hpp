// Holds one figure of an extreme case: its reference value, its tolerance and its result.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace keyblock::extremes {

/// A row of the table. Yes-or-no questions have the answers 1 and 0.
struct Extreme {
  std::string id;        ///< ext-01 …, as in the list of benchmarks
  std::string quantity;  ///< with its variant
  double expected = 0;
  double got = 0;
  double tolerance = 0;  ///< absolute
  std::string note;      ///< message of a program, or the reason for a figure

  /// Returns true if the figure misses. NaN always misses.
  bool holds() const { return std::abs(got - expected) <= tolerance; }
};

using Extremes = std::vector<Extreme>;

/// `brief` takes seconds; `full` takes minutes, with more steps and more variants of the same questions.
enum class Effort { brief, full };

Extremes mass_ratio(Effort effort);             ///< ext-01
Extremes stiffness_ratio(Effort effort);        ///< ext-02
Extremes penalty_sweep(Effort effort);          ///< ext-03
Extremes coordinate_offset(Effort effort);      ///< ext-04
Extremes slivers(Effort effort);                ///< ext-05
Extremes time_steps(Effort effort);             ///< ext-06
Extremes drift(Effort effort);                  ///< ext-07
Extremes degenerate_parameters(Effort effort);  ///< ext-08
Extremes wall_at_rest(Effort effort);           ///< ext-09
Extremes corner_on_corner(Effort effort);       ///< ext-10

/// Returns a case of the list above by its name.
struct ExtremeCase {
  const char* id;
  Extremes (*rows)(Effort);
};

/// Returns all cases in order.
const std::vector<ExtremeCase>& extreme_cases();

/// Writes the table: case, quantity, expected, found, tolerance, verdict, note.
std::string table_head();
std::string table_row(const Extreme& row);

}  // namespace keyblock::extremes
