// Writes the warnings of cutting; see cut_notes.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/cut_notes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/listed.hpp"
#include "base/sentences/sentences.hpp"
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

void CutNotes::warn(Finding finding, const Place& at) {
  result_.warnings.push_back(warning_of(std::move(finding), at));
}

// Counts lines as the file does, from 1.
std::size_t CutNotes::number(int line) const {
  return static_cast<std::size_t>(lines_.sources[line] - drawing_.joints.data()) + 1;
}

void CutNotes::of_repeated(const std::vector<std::size_t>& lines) {
  if (lines.empty()) return;
  const char* const form = lines.size() > 1 ? "duplicate_line:several" : "duplicate_line";
  warn({form, {{{"count", lines.size()}, {"line", lines.front()}}, {{"lines", listed(lines)}}}},
       drawing_.joints[lines.front() - 1].place);
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
  Facts facts{{{"pairs", count}, {"line", number(first->line)}, {"other_line", number(first->other)}}};
  facts.points = {{first->position.x, first->position.y}};
  warn({count == 1 ? "overlapping_lines" : "overlapping_lines:several", std::move(facts)}, place(first->line));
}

void CutNotes::of_dangling(const std::vector<char>& is_dangling) {
  const auto first = std::find(is_dangling.begin(), is_dangling.end(), 1);
  if (first == is_dangling.end()) return;
  const int line = static_cast<int>(first - is_dangling.begin());
  const auto count = std::count(is_dangling.begin(), is_dangling.end(), 1);
  warn({"dangling_lines_removed", {{{"count", count}, {"lines", is_dangling.size()}, {"line", number(line)}}}},
       place(line));
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
  Facts facts{{{"count", found.size()}, {"within", within}, {"gap", nearest.gap()}, {"line", number(line)}}};
  if (found.size() > 1) facts.numbers.emplace_back("farthest", farthest.gap());
  facts.points = {{nearest.from.x, nearest.from.y}};
  warn({found.size() == 1 ? "ends_stop_short" : "ends_stop_short:several", std::move(facts)}, place(line));
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
    Facts facts{{{"count", table.moves.size()}, {"within", tolerances().merge}}};
    for (const NodeMove& move : table.moves) facts.points.push_back({move.from.x, move.from.y});
    warn({"nodes_merged", std::move(facts)}, place(first.line));
  }
  result_.report.placed_otherwise = table.placed_otherwise;
  if (table.placed_otherwise > 0)
    warn({"nodes_placed_otherwise", {{{"count", table.placed_otherwise}}}}, drawing_.place);
  if (!table.undecided_nodes.empty()) {
    Facts facts{{{"count", table.undecided_nodes.size()}, {"within", tolerances().merge}}};
    for (const int node : table.undecided_nodes) {
      const Point at = table.arrangement.nodes[node].position;
      facts.points.push_back({at.x, at.y});
    }
    warn({"merging_left_close_nodes", std::move(facts)}, drawing_.place);
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
  Facts facts{
      {{"count", count}, {"percent_of_width", 100 * kFarInWidths}, {"width", width}, {"distance", way(*farthest)}}};
  facts.points = {{farthest->from.x, farthest->from.y}};
  warn({"nodes_merged_far", std::move(facts)}, farthest->place);
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

void CutNotes::of_removed(const char* form, const std::vector<Edge>& edges) {
  if (edges.empty()) return;
  std::vector<int> lines;
  for (const Edge& e : edges) lines.push_back(e.line);
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  const int first = lines.front();
  warn({form, {{{"count", edges.size()}, {"lines", lines.size()}, {"line", number(first)}}}}, place(first));
}

}  // namespace keyblock
