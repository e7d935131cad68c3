// Collects the warnings, snaps and counts of cutting.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cut/bodies/cut_result.hpp"
#include "cut/lines/crossings.hpp"
#include "cut/lines/nodes.hpp"

namespace keyblock {

/// Lines of non-zero length, each with its source in the drawing.
struct UsedLines {
  std::vector<Segment> segments;
  std::vector<const JointLine*> sources;
  std::size_t boundary_count = 0;
};

/// Adds what cutting finds to `result`. Keeps references to the drawing, the lines and the result.
class CutNotes {
 public:
  CutNotes(const Drawing& drawing, const UsedLines& lines, CutResult& result)
      : drawing_(drawing), lines_(lines), result_(result) {}

  const Place& place(int line) const { return lines_.sources[line]->place; }
  std::size_t number(int line) const;  ///< number in the file, from 1
  void warn(Finding finding, const Place& at);
  /// `lines`: numbers of lines in the file.
  void of_repeated(const std::vector<std::size_t>& lines);
  void of_overlaps(const std::vector<Crossing>& found);
  /// `is_dangling`: per line, true if a part of it has a free end.
  void of_dangling(const std::vector<char>& is_dangling);
  void of_merging(const std::vector<Crossing>& found, const NodeTable& table);
  /// Warns of crossings that moved so far that blocks have other shapes than drawn. Call it when there are blocks.
  void of_far_merging();
  /// Warns of free ends that stop just short of another line, with their distance and place.
  void of_near_ends(const std::vector<char>& is_dangling);
  void of_removed(const char* form, const std::vector<Edge>& edges);

 private:
  const CutTolerances& tolerances() const { return result_.report.tolerances; }
  void of_reach(const Crossing& c);

  const Drawing& drawing_;
  const UsedLines& lines_;
  CutResult& result_;
};

}  // namespace keyblock
