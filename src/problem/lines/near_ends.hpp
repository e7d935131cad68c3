// Finds ends of lines that stop just short of another line or pass it a little, with their distance, and joins them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "problem/drawing.hpp"
#include "problem/lines/segment_grid.hpp"

namespace keyblock {

/// End of a line near another line.
struct NearEnd {
  std::size_t line = 0;
  bool is_start = false;
  std::size_t other = 0;  ///< the line that it nearly meets
  Point from;             ///< the end
  Point to;               ///< short: the nearest point of the other line; beyond: the crossing
  bool is_beyond = false;

  double gap() const { return distance(from, to); }
};

/// Returns the round-off of the coordinates: ends nearer than this to a line meet it [length].
double meeting_distance(std::span<const Segment> lines);

/// Finds the line that an end nearly meets. Keeps a reference to the lines, which may move by `within` afterwards.
class NearEndSearch {
 public:
  /// `boundary_count`: number of lines of the outline. Its ends meet the outline itself before any joint.
  NearEndSearch(std::span<const Segment> lines, std::size_t boundary_count, double within);

  /// Returns the nearest line within the distance that the line of this end does not meet elsewhere. Returns nothing if
  /// the end meets a line, or passes one by no more than `overshoot`. Ends that pass a line farther, but within the
  /// distance and with no other line nearer, are `is_beyond`.
  std::optional<NearEnd> look(std::size_t line, bool is_start, double overshoot);

 private:
  /// Target of an end among the first lines.
  struct Found {
    bool is_met = false;
    std::optional<NearEnd> near = std::nullopt;
  };
  Found look_among(std::size_t count, std::size_t line, bool is_start, double overshoot);
  void look_at(std::size_t other, double overshoot, Found& found, const NearEnd& end) const;

  std::span<const Segment> lines_;
  std::size_t boundary_count_;
  double within_;
  double met_;
  SegmentGrid grid_;
};

/// Joins ends to lines nearer than `distance`. An end moves along its own line if that leads to the other within twice
/// the distance, else to its nearest point. Ends that pass a line by less are trimmed to it. Warns with the count, and
/// the place of the end moved farthest.
Warnings join_ends(Drawing& drawing, double distance);

}  // namespace keyblock
