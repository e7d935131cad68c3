// Writes the warnings of cutting; see cut_notes.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/cut_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/counted.hpp"
#include "base/listed.hpp"
#include "base/words/plain_number.hpp"
#include "cut/bodies/slivers.hpp"
#include "geometry/segment.hpp"
#include "problem/lines/near_ends.hpp"

namespace keyblock {
namespace {

// Limits of the distance at which a free end is likely meant to meet a line.
constexpr double kNearInMerges = 4;      // per merging distance
constexpr double kNearInScales = 0.005;  // per scale of the drawing
// Share of the width of the median block from which merging changes the shapes of blocks, and not only closes gaps.
constexpr double kFarInWidths = 0.05;

double median_width(const std::vector<BlockPolygon>& blocks) {
  std::vector<double> areas;
  for (const BlockPolygon& block : blocks) areas.push_back(form_of(block).area);
  const auto middle = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
  std::ranges::nth_element(areas, middle);
  return std::sqrt(*middle);
}

}  // namespace

void CutNotes::warn(std::string name, Place at, std::string sentence) {
  result_.warnings.push_back({std::move(name), std::move(at), std::move(sentence)});
}

// Counts lines as the file does, from 1.
std::size_t CutNotes::number(int line) const {
  return static_cast<std::size_t>(lines_.sources[line] - drawing_.joints.data()) + 1;
}

void CutNotes::of_repeated(const std::vector<std::size_t>& lines) {
  if (lines.empty()) return;
  const bool several = lines.size() > 1;
  warn("duplicate_line", drawing_.joints[lines.front() - 1].place,
       fmt::format("line{} {} {} earlier line{} and {} left out; the joint material is that of the earlier one",
                   several ? "s" : "", listed(lines), several ? "repeat" : "repeats an", several ? "s" : "",
                   several ? "are" : "is"));
}

void CutNotes::of_overlaps(const std::vector<Crossing>& found) {
  std::size_t count = 0;
  const Crossing* first = nullptr;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Crossing& c = found[k];
    const bool is_first = k == 0 || found[k - 1].line != c.line || found[k - 1].other != c.other;
    const bool is_pair =
        is_first && k + 1 < found.size() && found[k + 1].line == c.line && found[k + 1].other == c.other;
    if (!c.is_end || !is_pair) continue;
    ++count;
    if (first == nullptr) first = &c;
  }
  if (count == 0) return;
  warn("overlapping_lines", place(first->line),
       count == 1 ? fmt::format("the line partly covers line {}; the joint material is that of the earlier one",
                                number(first->other))
                  : fmt::format("{} pairs of lines cover each other in part, first this line and line {}; the joint "
                                "material is that of the earlier one",
                                count, number(first->other)));
}

void CutNotes::of_dangling(const std::vector<char>& is_dangling) {
  const auto first = std::find(is_dangling.begin(), is_dangling.end(), 1);
  if (first == is_dangling.end()) return;
  warn("dangling_lines_removed", place(static_cast<int>(first - is_dangling.begin())),
       fmt::format("loose ends of {} of {} are removed; this is the first",
                   std::count(is_dangling.begin(), is_dangling.end(), 1), counted(is_dangling.size(), "line")));
}

void CutNotes::of_near_ends(const std::vector<char>& is_dangling) {
  const double within = std::max(kNearInMerges * tolerances().merge, kNearInScales * tolerances().scale);
  if (std::ranges::find(is_dangling, 1) == is_dangling.end()) return;
  NearEndSearch search(lines_.segments, lines_.boundary_count, within);
  std::vector<NearEnd> found;
  for (std::size_t line = 0; line < is_dangling.size(); ++line)
    for (const bool is_start : {true, false}) {
      if (!is_dangling[line]) continue;
      const auto near = search.look(line, is_start, tolerances().merge);
      if (near && !near->is_beyond) found.push_back(*near);
    }
  if (found.empty()) return;
  const auto [nearest, farthest] = std::ranges::minmax(found, {}, &NearEnd::gap);
  const int line = static_cast<int>(nearest.line);
  const bool is_one = found.size() == 1;
  warn("ends_stop_short", place(line),
       fmt::format("{} less than {} short of another line and {} it nowhere, the nearest {} at ({}, {}), line {}{}; "
                   "--join DISTANCE joins those nearer than it",
                   is_one ? "1 end of a line stops" : fmt::format("{} ends of lines stop", found.size()),
                   plain(within, 3), is_one ? "meets" : "meet", plain(nearest.gap(), 3), plain(nearest.from.x, 6),
                   plain(nearest.from.y, 6), number(line),
                   is_one ? "" : fmt::format(", the farthest {}", plain(farthest.gap(), 3))));
}

void CutNotes::of_merging(const std::vector<Crossing>& found, const NodeTable& table) {
  for (const Crossing& c : found) {
    if (c.is_reached) of_reach(c);
  }
  for (const NodeMove& move : table.moves) {
    const Point to = table.arrangement.nodes[move.node].position;
    result_.snaps.push_back({Snap::Kind::node_merged, move.from, to, place(move.line)});
  }
  result_.report.merged = static_cast<int>(table.moves.size());
  if (!table.moves.empty()) {
    const NodeMove& first = table.moves.front();
    warn("nodes_merged", place(first.line),
         fmt::format("{} moved to a node nearer than {:.6g}, the first from ({:.9g}, {:.9g})",
                     counted(table.moves.size(), "crossing"), tolerances().merge, first.from.x, first.from.y));
  }
  result_.report.placed_otherwise = table.placed_otherwise;
  if (table.placed_otherwise > 0) {
    warn("nodes_placed_otherwise", drawing_.place,
         fmt::format("{} merged at a place set by the geometry, not at the first crossing that Shi's programs find",
                     counted(static_cast<std::size_t>(table.placed_otherwise), "node")));
  }
  if (!table.undecided_nodes.empty()) {
    const Point at = table.arrangement.nodes[table.undecided_nodes.front()].position;
    warn("merging_left_close_nodes", drawing_.place,
         fmt::format("{} nodes stay apart from a neighbour nearer than {:.6g}, because the group would "
                     "grow wider than "
                     "that; the first is ({:.9g}, {:.9g})",
                     table.undecided_nodes.size(), tolerances().merge, at.x, at.y));
  }
}

void CutNotes::of_far_merging() {
  const double width = median_width(result_.blocks.blocks);
  const auto way = [](const Snap& snap) { return distance(snap.from, snap.to); };
  const Snap* farthest = nullptr;
  std::size_t count = 0;
  for (const Snap& snap : result_.snaps) {
    if (snap.kind == Snap::Kind::end_reached || way(snap) <= kFarInWidths * width) continue;
    ++count;
    if (farthest == nullptr || way(snap) > way(*farthest)) farthest = &snap;
  }
  if (farthest == nullptr) return;
  warn("nodes_merged_far", farthest->place,
       fmt::format("{} moved by more than {:g} % of the width of a block ({}), the farthest by {} from ({}, {})",
                   counted(count, "crossing"), 100 * kFarInWidths, plain(width, 3), plain(way(*farthest), 3),
                   plain(farthest->from.x, 6), plain(farthest->from.y, 6)));
}

void CutNotes::of_reach(const Crossing& c) {
  ++result_.report.reached;
  for (const int line : {c.line, c.other}) {
    const double miss = distance(lines_.segments[line], c.position);
    if (miss <= tolerances().round_off) continue;
    const Segment& s = lines_.segments[line];
    const bool is_start = distance(s.start, c.position) < distance(s.end, c.position);
    result_.snaps.push_back({Snap::Kind::end_reached, is_start ? s.start : s.end, c.position, place(line)});
  }
}

void CutNotes::of_removed(const char* name, const char* why, const std::vector<Edge>& edges) {
  if (edges.empty()) return;
  std::vector<int> lines;
  for (const Edge& e : edges) lines.push_back(e.line);
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  warn(name, place(lines.front()),
       fmt::format("removed: {} of {}, which {}; the first is of this line", counted(edges.size(), "piece"),
                   counted(lines.size(), "line"), why));
}

}  // namespace keyblock
