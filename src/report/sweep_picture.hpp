// Draws the error of a run over two of its settings, as a map.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace keyblock::report {

struct SweptCell {
  double error = 0;     ///< > 0; not finite: no result
  std::string words;    ///< in a cell without a result: "failed"
  std::string details;  ///< shown where the pointer rests on it
};

struct SweepPicture {
  std::string title;
  std::string subtitle;
  std::vector<std::string> columns;  ///< headings
  std::vector<std::string> rows;     ///< headings, the topmost first
  std::string column_label;
  std::string row_label;
  std::vector<std::vector<SweptCell>> cells;  ///< by row
};

/// Returns an SVG document with one cell per run: its error, and a colour by its power of ten, dark for small errors.
/// A cell without a result is crossed.
std::string sweep_picture(const SweepPicture& picture);

}  // namespace keyblock::report
