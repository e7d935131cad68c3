// Returns curves and rows of the parts that move most, for runs whose user selected none.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/run_choices.hpp"
#include "report/drawing/chart.hpp"
#include "report/run_picture.hpp"
#include "result/field_frame.hpp"
#include "result/frame.hpp"
#include "result/history.hpp"

namespace keyblock {

/// Parts that pictures and tables of a run show by default: measured points, or the blocks or bodies that move most.
struct Shown {
  const History& history;
  const Frame& start;
  const FieldFrame& field;       ///< of the end
  std::vector<int> hidden = {};  ///< numbers, from 0, of blocks left out of pictures; of many blocks none
};

/// Returns the displacement of points, blocks or bodies over time; if there are many, of those that moved farthest.
std::vector<report::Curve> displacement_curves(const Shown& shown);

/// Returns the numbers of the same parts, and their places at the end.
std::vector<report::NumberedPlace> numbers_of_curves(const Shown& shown);
/// Returns "block whose curve is drawn", or the same for points and bodies.
std::string numbered_words(const Shown& shown);

/// Returns the displacements of the same parts as lines of histories.csv.
std::string most_moved_rows(const Shown& shown, const Units& units);

/// Returns the indices, in the rows of the history, of the parts that `history.csv` has. Empty for all: measured points
/// or few blocks. If there are many blocks, the indices of those that moved farthest.
std::vector<std::size_t> columns_of_history(const History& history, const std::vector<int>& hidden);

}  // namespace keyblock
