// Cuts a drawing into blocks; see cut_blocks.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/cut_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "cut/bodies/blocks_of_faces.hpp"
#include "cut/bodies/cut_notes.hpp"
#include "cut/bodies/place_points.hpp"
#include "cut/lines/crossings.hpp"
#include "cut/lines/faces.hpp"
#include "cut/lines/nodes.hpp"
#include "cut/lines/planarize.hpp"
#include "cut/lines/prune.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

bool is_finite(const Segment& s) {
  return std::isfinite(s.start.x) && std::isfinite(s.start.y) && std::isfinite(s.end.x) && std::isfinite(s.end.y);
}

/// Returns the end points in an order that does not depend on the direction of the line.
std::array<double, 4> ends_of(const Segment& s) {
  const std::pair start(s.start.x, s.start.y);
  const std::pair end(s.end.x, s.end.y);
  const auto& [low, high] = std::minmax(start, end);
  return {low.first, low.second, high.first, high.second};
}

/// Treatment of joints that bound no block.
enum class LooseEnds { removed, slits };

/// Performs one cutting, stage by stage.
class Cutting {
 public:
  Cutting(const Drawing& drawing, NodeMerging merging, NearPieces near_pieces, LooseEnds loose_ends)
      : drawing_(drawing), merging_(merging), near_pieces_(near_pieces), loose_ends_(loose_ends) {
    lines_ = used_lines();
    result_.report.tolerances = cut_tolerances(drawing);
    require_small_merging(drawing, tolerances());
    result_.report.lines = static_cast<int>(lines_.segments.size());
    result_.blocks.place = drawing.place;
    is_dangling_.assign(lines_.segments.size(), 0);
  }

  BodyCut run() {
    prune_edges(meet());
    if (!tolerances().is_exact()) straighten_out();
    if (loose_ends_ == LooseEnds::removed) notes_.of_dangling(is_dangling_);
    notes_.of_near_ends(is_dangling_);
    const std::vector<Face> faces = trace_faces(arrangement_);
    BlocksOfFaces blocks(arrangement_, faces, lines_, notes_, result_);
    blocks.make();
    if (result_.blocks.blocks.empty()) refuse();
    notes_.of_far_merging();
    PlacedMarks placed = place_marks(drawing_, tolerances(), result_.blocks);
    for (const int block : placed.kept) {
      const std::vector<int>& lines = blocks.lines_of_block(block);
      result_.joint_lines.insert(result_.joint_lines.end(), lines.begin(), lines.end());
    }
    result_.warnings = joined(std::move(result_.warnings), std::move(placed.warnings));
    BodyGraph graph;
    if (loose_ends_ == LooseEnds::slits) graph = blocks.graph(placed.kept, slits_);
    return {std::move(result_), std::move(graph)};
  }

 private:
  const CutTolerances& tolerances() const { return result_.report.tolerances; }
  const Place& place(int line) const { return notes_.place(line); }

  UsedLines used_lines() {
    UsedLines used;
    std::set<std::array<double, 4>> met;  // n coincident lines would make n² crossings
    std::vector<std::size_t> repeated;
    for (std::size_t i = 0; i < drawing_.joints.size(); ++i) {
      const JointLine& line = drawing_.joints[i];
      if (!is_finite(line.segment)) throw InputError(line.place, "expected finite coordinates of a line");
      if (line.segment.start == line.segment.end) {
        notes_.warn({"zero_length_line"}, line.place);
        continue;
      }
      if (!met.insert(ends_of(line.segment)).second) {
        repeated.push_back(i + 1);
        continue;
      }
      used.segments.push_back(line.segment);
      used.sources.push_back(&line);
      if (i < drawing_.boundary_count) ++used.boundary_count;
    }
    notes_.of_repeated(repeated);
    return used;
  }

  /// Finds crossings and nodes, and records their warnings.
  Arrangement meet() {
    const Crossings crossings = find_crossings(lines_.segments, tolerances());
    notes_.of_overlaps(crossings.found);
    mark_free_ends(crossings);
    NodeTable table = make_nodes(lines_.segments, lines_.boundary_count, crossings, tolerances(), merging_);
    notes_.of_merging(crossings.found, table);
    result_.report.crossings = static_cast<int>(crossings.found.size());
    result_.report.nodes = static_cast<int>(table.arrangement.nodes.size());
    result_.report.edges = static_cast<int>(table.arrangement.edges.size());
    if (loose_ends_ == LooseEnds::slits) keep_free_ends(crossings, table);
    return std::move(table.arrangement);
  }

  /// Makes nodes of the ends that reach past the last line they meet; the pieces in between become slits.
  void keep_free_ends(const Crossings& crossings, NodeTable& table) {
    std::vector<Node>& nodes = table.arrangement.nodes;
    const auto add = [&](Point end) {
      nodes.push_back({end, true});
      return static_cast<int>(nodes.size()) - 1;
    };
    for (std::size_t k = 0; k < lines_.segments.size(); ++k) {
      const Segment& s = lines_.segments[k];
      const int line = static_cast<int>(k);
      const std::size_t first = crossings.first_stop[k];
      const std::size_t end = crossings.first_stop[k + 1];
      if (first == end) {
        const int from = add(s.start);
        slits_.push_back({from, add(s.end), line, true});
        continue;
      }
      const auto is_free = [&](Point p, int node) { return distance(p, nodes[node].position) > tolerances().merge; };
      const int first_node = table.node_of_crossing[crossings.stops[first].crossing];
      const int last_node = table.node_of_crossing[crossings.stops[end - 1].crossing];
      if (is_free(s.start, first_node)) slits_.push_back({add(s.start), first_node, line, true});
      if (is_free(s.end, last_node)) slits_.push_back({last_node, add(s.end), line, true});
    }
  }

  /// Finds the ends that reach no other line, except overshoots of the merging distance. Drawings of bodies have such
  /// ends on purpose.
  void mark_free_ends(const Crossings& crossings) {
    constexpr double kRoundOffOfStation = 1e-12;
    for (std::size_t line = 0; line < lines_.segments.size(); ++line) {
      const std::size_t first = crossings.first_stop[line];
      const std::size_t end = crossings.first_stop[line + 1];
      const Segment& s = lines_.segments[line];
      const double slack = tolerances().merge / distance(s.start, s.end) + kRoundOffOfStation;
      is_dangling_[line] = first == end || crossings.stops[first].station.value > slack ||
                           crossings.stops[end - 1].station.value < 1 - slack;
    }
  }

  void prune_edges(Arrangement arrangement) {
    arrangement_ = std::move(arrangement);
    Pruning pruning = prune(arrangement_);
    result_.report.dangling_edges += static_cast<int>(pruning.dangling.size());
    result_.report.bridge_edges += static_cast<int>(pruning.bridges.size());
    for (const Edge& e : pruning.dangling) is_dangling_[e.line] = 1;
    if (loose_ends_ == LooseEnds::slits) {
      slits_.insert(slits_.end(), pruning.dangling.begin(), pruning.dangling.end());
      slits_.insert(slits_.end(), pruning.bridges.begin(), pruning.bridges.end());
    } else {
      notes_.of_removed("bridge_lines_removed", pruning.bridges);
    }
    arrangement_.edges = std::move(pruning.kept);
  }

  /// Turns the arrangement into a plane one again after merging has bent pieces.
  void straighten_out() {
    Planarized planar = planarize(std::move(arrangement_), lines_.boundary_count, tolerances(), near_pieces_);
    if (!planar.is_settled)
      throw InputError(drawing_.place, fmt::format("expected lines farther apart than {:.3g}, within which pieces are "
                                                   "led through points, found too many nearer to one another; a "
                                                   "smaller edge_node_ratio than {:g} keeps them apart",
                                                   tolerances().near_pass, drawing_.edge_node_ratio));
    for (const Detour& d : planar.detours) {
      result_.snaps.push_back(
          {Snap::Kind::edge_rerouted, d.from, planar.arrangement.nodes[d.node].position, place(d.line)});
    }
    result_.report.detours = static_cast<int>(planar.detours.size());
    result_.report.late_crossings = planar.crossings;
    if (!planar.detours.empty()) {
      Facts facts{{{"count", planar.detours.size()}, {"within", tolerances().near_pass}}};
      for (const Detour& d : planar.detours) facts.points.push_back({d.from.x, d.from.y});
      notes_.warn({"edges_rerouted", std::move(facts)}, place(planar.detours.front().line));
    }
    result_.report.deleted = static_cast<int>(planar.deleted.size());
    notes_.of_removed("near_pieces_deleted", planar.deleted);
    if (planar.detours.empty() && planar.crossings == 0 && planar.deleted.empty()) {
      arrangement_ = std::move(planar.arrangement);
    } else {
      prune_edges(std::move(planar.arrangement));
    }
  }

  [[noreturn]] void refuse() const {
    const auto is_of_gaps = [](const Warning& warning) { return warning.name == "ends_stop_short"; };
    const auto gaps = std::ranges::find_if(result_.warnings, is_of_gaps);
    throw InputError(
        drawing_.place,
        fmt::format("expected lines that close at least one block, found {} lines meeting in {} points and no "
                    "closed chain{}",
                    result_.report.lines, result_.report.nodes,
                    gaps == result_.warnings.end() ? "" : "; " + gaps->sentence));
  }

  const Drawing& drawing_;
  NodeMerging merging_;
  NearPieces near_pieces_;
  LooseEnds loose_ends_;
  UsedLines lines_;
  Arrangement arrangement_;
  std::vector<char> is_dangling_;  // per line: true if a part of it has a free end
  std::vector<Edge> slits_;        // pruned pieces and free ends, if they are kept
  CutResult result_;
  CutNotes notes_{drawing_, lines_, result_};
};

}  // namespace

CutResult cut_blocks(const Drawing& drawing, NodeMerging merging, NearPieces near_pieces) {
  return Cutting(drawing, merging, near_pieces, LooseEnds::removed).run().blocks;
}

BodyCut cut_bodies(const Drawing& drawing, NodeMerging merging, NearPieces near_pieces) {
  return Cutting(drawing, merging, near_pieces, LooseEnds::slits).run();
}

}  // namespace keyblock
