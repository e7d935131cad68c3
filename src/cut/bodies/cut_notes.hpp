// What cutting says of the lines of a drawing: warnings, snaps and counts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cut/bodies/cut_blocks.hpp"
#include "cut/lines/crossings.hpp"
#include "cut/lines/nodes.hpp"

namespace keyblock {

/// The lines that have a length, with what the drawing says of each.
struct UsedLines {
  std::vector<Segment> segments;
  std::vector<const JointLine*> sources;
  std::size_t boundary_count = 0;
};

/// Puts into `result` what is met on the way. Views the drawing, the lines and the result.
class CutNotes {
 public:
  CutNotes(const Drawing& drawing, const UsedLines& lines, CutResult& result)
      : drawing_(drawing), lines_(lines), result_(result) {}

  const Place& place(int line) const { return lines_.sources[line]->place; }
  std::size_t number(int line) const;  ///< in the file, from 1
  void warn(std::string name, Place at, std::string sentence);
  /// By the numbers of the lines in the file.
  void of_repeated(const std::vector<std::size_t>& lines);
  void of_overlaps(const std::vector<Crossing>& found);
  /// `is_dangling`: of each line, whether a part of it hangs loose.
  void of_dangling(const std::vector<char>& is_dangling);
  void of_merging(const std::vector<Crossing>& found, const NodeTable& table);
  /// Loose ends that stop just short of another line: how near, and where.
  void of_near_ends(const std::vector<char>& is_dangling);
  void of_removed(const char* name, const char* why, const std::vector<Edge>& edges);

 private:
  const CutTolerances& tolerances() const { return result_.report.tolerances; }
  void of_reach(const Crossing& c);

  const Drawing& drawing_;
  const UsedLines& lines_;
  CutResult& result_;
};

}  // namespace keyblock
