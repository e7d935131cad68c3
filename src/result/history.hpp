// Keeps rows of followed points over time, for tables and curves.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "result/frame.hpp"

namespace keyblock {

/// One instant of the followed points.
struct HistoryRow {
  int step = 0;
  double time = 0;
  /// Measured points by number; without any, the centroid of every element. A point that is not there has no place
  /// (`is_there`).
  std::vector<PointFrame> points;
  std::vector<double> bolt_forces;    ///< by number, tension positive; NaN of one that is not there
  std::vector<Point> reactions = {};  ///< as Frame has them
  std::vector<double> driven = {};  ///< of each prescribed displacement the mean of its length; none where not followed
  std::optional<double> load_share = {};      ///< of the scene's loads, where steps seek it
  std::optional<PlasticTotals> plastic = {};  ///< none where no rock may yield
  std::vector<TipState> tips = {};            ///< as Frame has them
  double load_factor = 1;                     ///< as Frame has it
};

/// Rows in the order of steps: those of every `stride`-th step, and the last one. Memory is bounded where the stride is
/// that of the run (`stride_of`).
struct History {
  bool of_measured_points = true;  ///< false: the rows hold centroids
  std::vector<HistoryRow> rows;
  int stride = 1;

  void add(HistoryRow row) {
    if (!rows.empty() && rows.back().step % stride != 0)
      rows.back() = std::move(row);
    else
      rows.push_back(std::move(row));
  }
};

}  // namespace keyblock
