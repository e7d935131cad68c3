// Ends of lines that stop just short of another line, or pass it a little: how near they come, and how to join them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "problem/drawing.hpp"
#include "problem/lines/segment_grid.hpp"

namespace keyblock {

/// An end of a line beside another line.
struct NearEnd {
  std::size_t line = 0;
  bool is_start = false;
  std::size_t other = 0;  ///< the line that it nearly meets
  Point from;             ///< the end
  Point to;               ///< short: the nearest point of the other line; beyond: the crossing
  bool is_beyond = false;

  double gap() const { return distance(from, to); }
};

/// Round-off of the coordinates: ends nearer than this to a line meet it [length].
double meeting_distance(std::span<const Segment> lines);

/// Looks for the line that an end nearly meets. Views the lines, which may move by `within` after it is made.
class NearEndSearch {
 public:
  /// `boundary_count`: how many of the lines are an outline. Its ends meet the outline itself before any joint.
  NearEndSearch(std::span<const Segment> lines, std::size_t boundary_count, double within);

  /// The nearest line within the distance that the line of this end does not meet elsewhere. Nothing if the end meets a
  /// line, or if it passes one by no more than `overshoot`. Ends that pass a line farther than that, but within the
  /// distance and with no other line nearer, are `is_beyond`.
  std::optional<NearEnd> look(std::size_t line, bool is_start, double overshoot);

 private:
  /// The target of an end among the first lines.
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

/// Joins ends to lines nearer than `distance`: along their own line if that leads to the other within twice the
/// distance, else to its nearest point; ends that pass a line by less are trimmed to it. Tells how many, and
/// the one moved farthest with its place.
Warnings join_ends(Drawing& drawing, double distance);

}  // namespace keyblock
