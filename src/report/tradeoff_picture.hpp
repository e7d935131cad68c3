// Draws runs by their cost and their error, with the Pareto front.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace keyblock::report {

/// A run with a result.
struct PricedRun {
  std::string name;
  double seconds = 0;  ///< > 0
  double error = 0;    ///< > 0
  bool is_profile = false;
  bool is_on_front = false;
  bool is_near_front = false;  ///< on it within the noise of timings: drawn filled
  std::string details;         ///< shown where the pointer rests on it
};

struct TradeoffPicture {
  std::string title;
  std::string subtitle;
  std::vector<PricedRun> runs;
  double least_error = 0;  ///< errors below it are not distinguished; 0: unknown
};

/// Returns an SVG document: error over processor time, both in powers of ten. A staircase joins the front; its runs and
/// the profiles are named if there is room. Without runs the page has only the titles.
std::string tradeoff_picture(const TradeoffPicture& picture);

}  // namespace keyblock::report
