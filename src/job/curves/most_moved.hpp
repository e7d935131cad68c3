// Curves and rows of what moves most, where nobody chose what to follow.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/run_choices.hpp"
#include "report/drawing/chart.hpp"
#include "result/field_frame.hpp"
#include "result/frame.hpp"
#include "result/history.hpp"

namespace keyblock {

/// How far each of few points, blocks or bodies has come, over time; of many those that came farthest.
std::vector<report::Curve> displacement_curves(const History& history, const Frame& start, const FieldFrame& field);

/// Of the same the displacements, as lines of histories.csv.
std::string most_moved_rows(const History& history, const Frame& start, const FieldFrame& field, const Units& units);

}  // namespace keyblock
