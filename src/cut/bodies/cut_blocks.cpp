// Drawing to blocks; see cut_blocks.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/cut_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "base/listed.hpp"
#include "cut/bodies/place_points.hpp"
#include "cut/lines/crossings.hpp"
#include "cut/lines/faces.hpp"
#include "cut/lines/nodes.hpp"
#include "cut/lines/planarize.hpp"
#include "cut/lines/prune.hpp"
#include "geometry/predicates.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

/// The lines that have a length, with what the drawing says of each.
struct UsedLines {
  std::vector<Segment> segments;
  std::vector<const JointLine*> sources;
  std::size_t boundary_count = 0;
};

bool is_finite(const Segment& s) {
  return std::isfinite(s.start.x) && std::isfinite(s.start.y) && std::isfinite(s.end.x) && std::isfinite(s.end.y);
}

/// The same whichever way the line runs.
std::array<double, 4> ends_of(const Segment& s) {
  const std::pair start(s.start.x, s.start.y);
  const std::pair end(s.end.x, s.end.y);
  const auto& [low, high] = std::minmax(start, end);
  return {low.first, low.second, high.first, high.second};
}

/// What becomes of joints that bound nothing.
enum class LooseEnds { removed, slits };

/// One cutting, from stage to stage.
class Cutting {
 public:
  Cutting(const Drawing& drawing, NodeMerging merging, NearPieces near_pieces, LooseEnds loose_ends)
      : drawing_(drawing), merging_(merging), near_pieces_(near_pieces), loose_ends_(loose_ends) {
    lines_ = used_lines();
    result_.report.tolerances = cut_tolerances(drawing);
    result_.report.lines = static_cast<int>(lines_.segments.size());
    result_.blocks.place = drawing.place;
    is_dangling_.assign(lines_.segments.size(), 0);
  }

  BodyCut run() {
    prune_edges(meet());
    if (!tolerances().is_exact()) straighten_out();
    if (loose_ends_ == LooseEnds::removed) report_dangling();
    const std::vector<Face> faces = trace_faces(arrangement_);
    make_blocks(faces);
    if (result_.blocks.blocks.empty()) refuse();
    PlacedMarks placed = place_marks(drawing_, tolerances(), result_.blocks);
    for (const int block : placed.kept) {
      const std::vector<int>& lines = lines_of_block_[static_cast<std::size_t>(block)];
      result_.joint_lines.insert(result_.joint_lines.end(), lines.begin(), lines.end());
    }
    result_.warnings = joined(std::move(result_.warnings), std::move(placed.warnings));
    BodyGraph graph;
    if (loose_ends_ == LooseEnds::slits) graph = body_graph(faces, placed.kept);
    return {std::move(result_), std::move(graph)};
  }

 private:
  const CutTolerances& tolerances() const { return result_.report.tolerances; }
  const Place& place(int line) const { return lines_.sources[line]->place; }
  int material(int line) const { return lines_.sources[line]->joint_material; }

  void warn(std::string name, Place at, std::string sentence) {
    result_.warnings.push_back({std::move(name), std::move(at), std::move(sentence)});
  }

  UsedLines used_lines() {
    UsedLines used;
    std::set<std::array<double, 4>> met;  // n lines in one place would make n² crossings
    std::vector<std::size_t> repeated;
    for (std::size_t i = 0; i < drawing_.joints.size(); ++i) {
      const JointLine& line = drawing_.joints[i];
      if (!is_finite(line.segment)) throw InputError(line.place, "expected finite coordinates of a line");
      if (line.segment.start == line.segment.end) {
        warn("zero_length_line", line.place, "the line has no length and is left out");
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
    report_repeated(repeated);
    return used;
  }

  /// By the numbers of the lines in the file.
  void report_repeated(const std::vector<std::size_t>& lines) {
    if (lines.empty()) return;
    const bool several = lines.size() > 1;
    warn("duplicate_line", drawing_.joints[lines.front() - 1].place,
         fmt::format("line{} {} {} earlier line{} and {} left out; the joint material is that of the earlier one",
                     several ? "s" : "", listed(lines), several ? "repeat" : "repeats an", several ? "s" : "",
                     several ? "are" : "is"));
  }

  /// Crossings and nodes, with what is to be said of them.
  Arrangement meet() {
    const Crossings crossings = find_crossings(lines_.segments, tolerances());
    report_overlaps(crossings.found);
    mark_free_ends(crossings);
    NodeTable table = make_nodes(lines_.segments, lines_.boundary_count, crossings, tolerances(), merging_);
    report_merging(crossings.found, table);
    result_.report.crossings = static_cast<int>(crossings.found.size());
    result_.report.nodes = static_cast<int>(table.arrangement.nodes.size());
    result_.report.edges = static_cast<int>(table.arrangement.edges.size());
    if (loose_ends_ == LooseEnds::slits) keep_free_ends(crossings, table);
    return std::move(table.arrangement);
  }

  /// Ends that reach past the last line they meet become nodes of their own, and what lies between becomes slits.
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

  void report_overlaps(const std::vector<Crossing>& found) {
    for (std::size_t k = 0; k < found.size(); ++k) {
      const Crossing& c = found[k];
      const bool is_first = k == 0 || found[k - 1].line != c.line || found[k - 1].other != c.other;
      const bool is_pair =
          is_first && k + 1 < found.size() && found[k + 1].line == c.line && found[k + 1].other == c.other;
      if (!c.is_end || !is_pair) continue;
      warn("overlapping_lines", place(c.line),
           fmt::format("the line partly covers line {}; the joint material is that of the earlier one",
                       number(c.other)));
    }
  }

  /// Ends that reach no other line, overshoots of the merging distance excepted: drawings are meant to have
  /// these.
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

  void report_dangling() {
    const auto first = std::find(is_dangling_.begin(), is_dangling_.end(), 1);
    if (first == is_dangling_.end()) return;
    warn("dangling_lines_removed", place(static_cast<int>(first - is_dangling_.begin())),
         fmt::format("{} of {} lines have parts that hang loose and are removed; this is the first",
                     std::count(is_dangling_.begin(), is_dangling_.end(), 1), is_dangling_.size()));
  }

  /// As the file counts lines, from 1.
  std::size_t number(int line) const {
    return static_cast<std::size_t>(lines_.sources[line] - drawing_.joints.data()) + 1;
  }

  void report_merging(const std::vector<Crossing>& found, const NodeTable& table) {
    for (const Crossing& c : found) {
      if (c.is_reached) report_reach(c);
    }
    for (const NodeMove& move : table.moves) {
      const Point to = table.arrangement.nodes[move.node].position;
      result_.snaps.push_back({Snap::Kind::node_merged, move.from, to, place(move.line)});
    }
    result_.report.merged = static_cast<int>(table.moves.size());
    if (!table.moves.empty()) {
      const NodeMove& first = table.moves.front();
      warn("nodes_merged", place(first.line),
           fmt::format("{} crossings were moved to a node nearer than {:.6g}, the first from ({:.9g}, {:.9g})",
                       table.moves.size(), tolerances().merge, first.from.x, first.from.y));
    }
    result_.report.placed_otherwise = table.placed_otherwise;
    if (table.placed_otherwise > 0) {
      warn("nodes_placed_otherwise", drawing_.place,
           fmt::format("{} merged nodes stand where the drawing decides, not at the crossing that the old programs "
                       "would have found first",
                       table.placed_otherwise));
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

  void report_reach(const Crossing& c) {
    ++result_.report.reached;
    for (const int line : {c.line, c.other}) {
      const double miss = distance(lines_.segments[line], c.position);
      if (miss <= tolerances().round_off) continue;
      const Segment& s = lines_.segments[line];
      const bool is_start = distance(s.start, c.position) < distance(s.end, c.position);
      result_.snaps.push_back({Snap::Kind::end_reached, is_start ? s.start : s.end, c.position, place(line)});
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
      report_removed("bridge_lines_removed", "have the same block on both sides", pruning.bridges);
    }
    arrangement_.edges = std::move(pruning.kept);
  }

  void report_removed(const char* name, const char* why, const std::vector<Edge>& edges) {
    if (edges.empty()) return;
    std::vector<int> lines;
    for (const Edge& e : edges) lines.push_back(e.line);
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    warn(name, place(lines.front()),
         fmt::format("{} pieces of {} lines {} and are removed; the first is of this line", edges.size(), lines.size(),
                     why));
  }

  /// What merging has bent is made a plane drawing again.
  void straighten_out() {
    Planarized planar = planarize(std::move(arrangement_), lines_.boundary_count, tolerances(), near_pieces_);
    for (const Detour& d : planar.detours) {
      result_.snaps.push_back(
          {Snap::Kind::edge_rerouted, d.from, planar.arrangement.nodes[d.node].position, place(d.line)});
    }
    result_.report.detours = static_cast<int>(planar.detours.size());
    result_.report.late_crossings = planar.crossings;
    if (!planar.detours.empty()) {
      warn("edges_rerouted", place(planar.detours.front().line),
           fmt::format("{} pieces pass a node nearer than {:.6g} and are led through it", planar.detours.size(),
                       tolerances().near_pass));
    }
    result_.report.deleted = static_cast<int>(planar.deleted.size());
    report_removed("near_pieces_deleted", "pass a node too near, or cross another, as the old programs see it,",
                   planar.deleted);
    if (planar.detours.empty() && planar.crossings == 0 && planar.deleted.empty()) {
      arrangement_ = std::move(planar.arrangement);
    } else {
      prune_edges(std::move(planar.arrangement));
    }
  }

  void make_blocks(const std::vector<Face>& faces) {
    result_.report.faces = static_cast<int>(faces.size());
    result_.report.pruned_edges = static_cast<int>(arrangement_.edges.size());
    std::vector<char> is_used(arrangement_.nodes.size(), 0);
    for (const Edge& e : arrangement_.edges) is_used[e.from] = is_used[e.to] = 1;
    result_.report.pruned_nodes = static_cast<int>(std::count(is_used.begin(), is_used.end(), 1));
    for (std::size_t i = 0; i < faces.size(); ++i) add_block(faces[i], static_cast<int>(i));
  }

  void add_block(const Face& face, int number_of_face) {
    std::vector<int> lines;
    BlockPolygon block{0, make_loop(face.outer, lines), {}};
    if (block.outer.size() < 3) {
      warn("sliver_removed", place(face.outer.front().line), "the lines close a block without an area; it is left out");
      return;
    }
    for (const Chain& hole : face.holes) {
      std::vector<int> lines_of_hole;
      BlockLoop loop = make_loop(hole, lines_of_hole);
      if (loop.size() < 3) continue;
      lines.insert(lines.end(), lines_of_hole.begin(), lines_of_hole.end());
      warn("block_inside_block", place(hole.front().line),
           fmt::format("a closed loop lies inside block {}: it is cut out there (the old programs count its "
                       "area twice)",
                       result_.blocks.blocks.size() + 1));
      block.holes.push_back(std::move(loop));
    }
    result_.blocks.blocks.push_back(std::move(block));
    face_of_block_.push_back(number_of_face);
    lines_of_block_.push_back(std::move(lines));
  }

  /// `kept`: of each block its number before the holes were removed.
  BodyGraph body_graph(const std::vector<Face>& faces, const std::vector<int>& kept) const {
    BodyGraph graph;
    graph.nodes.reserve(arrangement_.nodes.size());
    for (const Node& node : arrangement_.nodes) graph.nodes.push_back(node.position);
    for (const Edge& e : arrangement_.edges) graph.pieces.push_back({e.from, e.to, false, -1, -1, material(e.line)});
    for (std::size_t body = 0; body < kept.size(); ++body) {
      const Face& face = faces[face_of_block_[kept[body]]];
      const auto mark = [&](const Chain& chain) {
        for (const ChainLink& link : chain) {
          BodyPiece& piece = graph.pieces[link.half_edge / 2];
          (link.half_edge % 2 == 0 ? piece.left : piece.right) = static_cast<int>(body);
        }
      };
      mark(face.outer);
      for (const Chain& hole : face.holes) mark(hole);
      graph.materials.push_back(result_.blocks.blocks[body].material);
    }
    for (const Edge& e : slits_) graph.pieces.push_back({e.from, e.to, true, -1, -1, material(e.line)});
    return graph;
  }

  /// Leaves out straight vertices; an edge so joined keeps the material of its last part, and so does its line, which
  /// is put behind `lines`.
  BlockLoop make_loop(const Chain& chain, std::vector<int>& lines) const {
    BlockLoop loop;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const ChainLink& before = chain[i == 0 ? chain.size() - 1 : i - 1];
      const ChainLink& after = chain[i + 1 == chain.size() ? 0 : i + 1];
      if (is_straight(before, chain[i], after)) continue;
      loop.push_back({arrangement_.nodes[chain[i].node].position, material(chain[i].line)});
      lines.push_back(static_cast<int>(number(chain[i].line)) - 1);
    }
    return loop;
  }

  bool is_straight(const ChainLink& before, const ChainLink& here, const ChainLink& after) const {
    const Point a = arrangement_.nodes[before.node].position;
    const Point b = arrangement_.nodes[here.node].position;
    const Point c = arrangement_.nodes[after.node].position;
    if (tolerances().is_exact()) {
      const Segment& first = arrangement_.lines[here.line];
      const Segment& second = arrangement_.lines[after.line];
      return here.line == after.line || turn(first.start, first.end, second.start, second.end) == 0;
    }
    return std::fabs(cross(b - a, c - a)) <= tolerances().collinear;
  }

  [[noreturn]] void refuse() const {
    throw InputError(
        drawing_.place,
        fmt::format("expected lines that close at least one block, found {} lines meeting in {} points and no "
                    "closed chain",
                    result_.report.lines, result_.report.nodes));
  }

  const Drawing& drawing_;
  NodeMerging merging_;
  NearPieces near_pieces_;
  LooseEnds loose_ends_;
  UsedLines lines_;
  Arrangement arrangement_;
  std::vector<char> is_dangling_;                 // of each line: a part of it hangs loose
  std::vector<Edge> slits_;                       // what pruning removed, and free ends, where they are kept
  std::vector<int> face_of_block_;                // before holes are removed
  std::vector<std::vector<int>> lines_of_block_;  // likewise: the joint of each edge
  CutResult result_;
};

}  // namespace

CutResult cut_blocks(const Drawing& drawing, NodeMerging merging, NearPieces near_pieces) {
  return Cutting(drawing, merging, near_pieces, LooseEnds::removed).run().blocks;
}

BodyCut cut_bodies(const Drawing& drawing, NodeMerging merging, NearPieces near_pieces) {
  return Cutting(drawing, merging, near_pieces, LooseEnds::slits).run();
}

}  // namespace keyblock
