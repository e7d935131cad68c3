// Curves and rows of what moves most, where nobody chose what to follow.
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

/// What pictures and tables of a run show where nobody chose: measured points, or the blocks or bodies that move most.
struct Shown {
  const History& history;
  const Frame& start;
  const FieldFrame& field;       ///< of the end
  std::vector<int> hidden = {};  ///< numbers, from 0, of blocks that pictures leave out: of many blocks none of them
};

/// How far each of few points, blocks or bodies has come, over time; of many those that came farthest.
std::vector<report::Curve> displacement_curves(const Shown& shown);

/// Of the same the numbers, where they lie at the end.
std::vector<report::NumberedPlace> numbers_of_curves(const Shown& shown);
/// "block whose curve is drawn".
std::string numbered_words(const Shown& shown);

/// Of the same the displacements, as lines of histories.csv.
std::string most_moved_rows(const Shown& shown, const Units& units);

/// Places in the rows of the history of what `history.csv` has: empty for all, measured points or few blocks; of many
/// blocks those that came farthest, by their numbers.
std::vector<std::size_t> columns_of_history(const History& history, const std::vector<int>& hidden);

}  // namespace keyblock
