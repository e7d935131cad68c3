// Draws the results of a sweep over one or two keys.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace keyblock::report {

/// Column of the table, by run.
struct ValuesColumn {
  std::string name;
  std::vector<double> numbers;     ///< NaN: no number
  std::vector<std::string> words;  ///< shown for a key that is not a number
};

struct ValuesPicture {
  std::string title;
  std::vector<ValuesColumn> keys;
  std::vector<ValuesColumn> outputs;
  std::vector<std::string> verdicts;  ///< of each run
};

/// Returns an SVG document: one panel per output with numbers. A chart over one key; over two keys a map with one mark
/// per run, coloured by value and crossed without one. Empty for more keys, and without numbers.
std::string values_picture(const ValuesPicture& picture);

}  // namespace keyblock::report
