// Draws a run: its start, its end, and curves of the time between.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/run_choices.hpp"
#include "report/drawing/chart.hpp"
#include "result/frame.hpp"

namespace keyblock::report {

/// Number beside a place of the end, of a curve.
struct NumberedPlace {
  std::string words;
  Point at;
};

struct RunPicture {
  std::string title;
  Frame start;                             ///< drawn as dashed outlines, where an element moved
  Frame end;                               ///< drawn filled
  std::vector<Curve> curves;               ///< without two points of any the chart is left out
  AxisLabels axes;                         ///< of the chart, with units: "time [s]", "displacement [m]"
  std::string time_unit;                   ///< for the legend, e.g. "s"; may be empty
  std::vector<int> marked = {};            ///< numbers, from 0, of elements at which a run failed: edged and pointed at
  std::string marked_words = {};           ///< what they do, for the legend: "accelerates"
  Units units = {};                        ///< of the scale bar
  std::vector<std::size_t> left_out = {};  ///< elements of the end, in their order, that the picture leaves out
  std::vector<NumberedPlace> numbers = {};  ///< of the parts with curves
  std::string numbered_words = {};          ///< numbered parts, for the legend: "block whose curve is drawn"
  /// At the end the joint material of the edge that arrives at each corner of an element, loop after loop, by the
  /// element's number; below 0: none. Drawn in colours if there is more than one.
  std::vector<std::vector<int>> joints = {};
  std::vector<std::string> rock_names = {};   ///< by block material, from 0
  std::vector<std::string> joint_names = {};  ///< by joint material
  std::vector<int> idle_bolts = {};           ///< numbers, from 0, of bolts without properties
};

/// Returns the indices in `end` of elements that every picture of a run leaves out: small blocks far away from the
/// drawing (`far_small_blocks`). Blocks that failed (`marked`, numbers from 0) or carry a point stay; scenes with bolts
/// and bodies of many elements are shown whole.
std::vector<std::size_t> left_out_of(const Frame& start, const Frame& end, const std::vector<int>& marked);

/// Returns an SVG document. The chart is below a wide scene and beside a tall one.
std::string run_picture(RunPicture picture);

}  // namespace keyblock::report
