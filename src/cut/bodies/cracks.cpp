// Finds slits from chains, and tips from pieces with an end that no other piece shares.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/cracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/box.hpp"
#include "geometry/predicates.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

// Shares of the extent of all pieces. Distances up to the first are rounding; the second is the prolongation of an end
// beyond the line that it is meant to meet.
constexpr double kRounding = 1e-13;
constexpr double kBeyond = 1e-10;

Segment segment_of(const BodyGraph& graph, const BodyPiece& piece) {
  return {graph.nodes[static_cast<std::size_t>(piece.from)], graph.nodes[static_cast<std::size_t>(piece.to)]};
}

double extent_of(const BodyGraph& graph) {
  Box box;
  for (const Point p : graph.nodes) box.add(p);
  return graph.nodes.empty() ? 0 : length(box.size());
}

void require_length(const CrackPlan& crack) {
  if (crack.along.size() < 2) throw InputError(crack.place, "expected two points of a crack at least");
  for (std::size_t i = 0; i + 1 < crack.along.size(); ++i)
    if (crack.along[i] == crack.along[i + 1])
      throw InputError(crack.place,
                       fmt::format("expected a crack of pieces with a length, found ({:.9g}, {:.9g}) twice in a row",
                                   crack.along[i].x, crack.along[i].y));
}

class CrackedGraph {
 public:
  /// `before`: cracks already in the graph.
  CrackedGraph(BodyGraph& graph, std::span<const CrackPlan> before)
      : graph_(graph), before_(before), extent_(extent_of(graph)) {}

  /// Tests the middle of each part between crossings with outlines, because a piece may cross bodies from side to side.
  bool holds_some_of(const CrackPlan& crack) const {
    for (std::size_t i = 0; i + 1 < crack.along.size(); ++i) {
      const Segment piece{crack.along[i], crack.along[i + 1]};
      const std::vector<double> stations = crossings(piece);
      for (std::size_t k = 0; k + 1 < stations.size(); ++k)
        if (stations[k + 1] > stations[k] &&
            is_in_a_body(graph_, point_at(piece, 0.5 * (stations[k] + stations[k + 1]))))
          return true;
    }
    return false;
  }

  void add(const CrackPlan& crack) {
    std::vector<Point> along = crack.along;
    for (std::size_t i = 0; i + 1 < along.size(); ++i) require_apart(crack, {along[i], along[i + 1]});
    for (std::size_t i = 0; i + 2 < along.size(); ++i)
      for (std::size_t j = i + 1; j + 1 < along.size(); ++j)
        require_apart(crack, {along[j], along[j + 1]}, {along[i], along[i + 1]}, "itself");
    along.front() = prolonged(along[1], along.front());
    along.back() = prolonged(along[along.size() - 2], along.back());
    int from = node_at(along.front());
    for (std::size_t i = 1; i < along.size(); ++i) {
      const int to = node_at(along[i]);
      graph_.pieces.push_back({from, to, true, -1, -1, crack.joint_material});
      from = to;
    }
  }

 private:
  std::vector<double> crossings(const Segment& piece) const {
    std::vector<double> stations{0, 1};
    for (const BodyPiece& other : graph_.pieces) {
      const Segment outline = segment_of(graph_, other);
      if (other.is_slit || meeting(piece, outline) != Meeting::crossing) continue;
      const double from = cross(outline.end - outline.start, piece.start - outline.start);
      const double to = cross(outline.end - outline.start, piece.end - outline.start);
      if (from != to) stations.push_back(std::clamp(from / (from - to), 0.0, 1.0));
    }
    std::ranges::sort(stations);
    return stations;
  }

  void require_apart(const CrackPlan& crack, const Segment& piece) const {
    for (const BodyPiece& other : graph_.pieces) {
      require_apart(crack, piece, segment_of(graph_, other),
                    other.is_slit ? "a joint or another crack" : "the outline of a body");
    }
  }

  void require_apart(const CrackPlan& crack, const Segment& piece, const Segment& there, const char* what) const {
    if (meeting(piece, there) != Meeting::overlapping) return;
    // Pieces that share one point do not overlap.
    const double a = foot(piece, there.start), b = foot(piece, there.end);
    if (std::min(std::max(a, b), 1.0) - std::max(std::min(a, b), 0.0) <= 0) return;
    const Point from = as_drawn(there.start), to = as_drawn(there.end);
    throw InputError(crack.place,
                     fmt::format("expected a crack apart from other lines, found it along {} from ({:.9g}, "
                                 "{:.9g}) to ({:.9g}, {:.9g})",
                                 what, from.x, from.y, to.x, to.y));
  }

  // Returns the end as the file has it, before `prolonged` moved it.
  Point as_drawn(Point p) const {
    for (const CrackPlan& crack : before_)
      for (const Point end : {crack.along.front(), crack.along.back()})
        if (distance(end, p) <= 2 * kBeyond * extent_) return end;
    return p;
  }

  Point prolonged(Point from, Point end) const {
    if (std::ranges::find(graph_.nodes, end) != graph_.nodes.end()) return end;
    for (const BodyPiece& other : graph_.pieces)
      if (distance(segment_of(graph_, other), end) <= kRounding * extent_)
        return end + (kBeyond * extent_ / distance(from, end)) * (end - from);
    return end;
  }

  int node_at(Point p) {
    const auto found = std::ranges::find(graph_.nodes, p);
    if (found != graph_.nodes.end()) return static_cast<int>(found - graph_.nodes.begin());
    graph_.nodes.push_back(p);
    return static_cast<int>(graph_.nodes.size()) - 1;
  }

  BodyGraph& graph_;
  std::span<const CrackPlan> before_;
  double extent_;
};

/// Lists the slits at each node, and if an outline passes it.
class SlitEnds {
 public:
  explicit SlitEnds(const BodyGraph& graph) : graph_(graph), extent_(extent_of(graph)) {
    slits_.resize(graph.nodes.size());
    outlines_.assign(graph.nodes.size(), 0);
    for (std::size_t p = 0; p < graph.pieces.size(); ++p) {
      const BodyPiece& piece = graph.pieces[p];
      for (const int node : {piece.from, piece.to}) {
        if (piece.is_slit)
          slits_[static_cast<std::size_t>(node)].push_back(static_cast<int>(p));
        else
          outlines_[static_cast<std::size_t>(node)] = 1;
      }
    }
  }

  std::vector<CrackTip> tips() const {
    std::vector<CrackTip> found;
    for (const BodyPiece& piece : graph_.pieces) {
      if (!piece.is_slit) continue;
      for (const int end : {piece.from, piece.to}) {
        const auto n = static_cast<std::size_t>(end);
        if (slits_[n].size() != 1 || outlines_[n]) continue;
        const Point at = graph_.nodes[n];
        if (is_in_a_body(graph_, at) && !lies_on_another(at, piece)) found.push_back(tip_at(end));
      }
    }
    for (CrackTip& tip : found)
      for (const CrackTip& other : found)
        if (const double d = distance(tip.at, other.at); d > 0 && d < tip.room) {
          tip.room = d;
          tip.nearest = "another tip";
        }
    return found;
  }

 private:
  bool lies_on_another(Point at, const BodyPiece& own) const {
    return std::ranges::any_of(graph_.pieces, [&](const BodyPiece& other) {
      return &other != &own && distance(segment_of(graph_, other), at) <= 2 * kBeyond * extent_;
    });
  }

  int other_end(int piece, int node) const {
    const BodyPiece& p = graph_.pieces[static_cast<std::size_t>(piece)];
    return p.from == node ? p.to : p.from;
  }

  /// Returns the pieces of the straight end of the slit at node `tip`.
  std::vector<int> straight_end(int tip) const {
    std::vector<int> run{slits_[static_cast<std::size_t>(tip)].front()};
    for (int node = other_end(run.front(), tip);;) {
      const std::vector<int>& slits = slits_[static_cast<std::size_t>(node)];
      if (slits.size() != 2 || outlines_[static_cast<std::size_t>(node)]) return run;
      const int next = slits[0] == run.back() ? slits[1] : slits[0];
      const int beyond = other_end(next, node);
      const Point back = at(node) - at(tip), on = at(beyond) - at(node);
      if (std::abs(cross(back, on)) > kRounding * length(back) * length(on) || dot(back, on) < 0) return run;
      run.push_back(next);
      node = beyond;
    }
  }

  CrackTip tip_at(int node) const {
    const std::vector<int> run = straight_end(node);
    const Point here = at(node);
    const Point back = at(other_end(run.front(), node)) - here;
    CrackTip tip{here, (-1 / length(back)) * back, std::numeric_limits<double>::max(), ""};
    for (std::size_t p = 0; p < graph_.pieces.size(); ++p) {
      if (std::ranges::find(run, static_cast<int>(p)) != run.end()) continue;
      const BodyPiece& piece = graph_.pieces[p];
      const double d = distance(segment_of(graph_, piece), here);
      if (d >= tip.room) continue;
      tip.room = d;
      tip.nearest = !piece.is_slit        ? "the outline of a body"
                    : is_next(piece, run) ? "a kink of the crack itself"
                                          : "a joint or another crack";
    }
    return tip;
  }

  bool is_next(const BodyPiece& piece, const std::vector<int>& run) const {
    const BodyPiece& last = graph_.pieces[static_cast<std::size_t>(run.back())];
    const auto shares = [&](int node) { return node == piece.from || node == piece.to; };
    return shares(last.from) || shares(last.to);
  }

  Point at(int node) const { return graph_.nodes[static_cast<std::size_t>(node)]; }

  const BodyGraph& graph_;
  double extent_;
  std::vector<std::vector<int>> slits_;  // pieces at each node
  std::vector<char> outlines_;           // true if an outline has the node
};

}  // namespace

bool is_in_a_body(const BodyGraph& graph, Point p) {
  bool is_in = false;
  for (const BodyPiece& piece : graph.pieces) {
    if ((piece.left < 0) == (piece.right < 0)) continue;  // a slit, or an outline between two bodies
    const Segment s = segment_of(graph, piece);
    const bool goes_up = s.end.y > s.start.y;
    const Segment up = goes_up ? s : Segment{s.end, s.start};
    if (p.y < up.start.y || p.y >= up.end.y) continue;
    if (orientation(up.start, up.end, p) > 0) is_in = !is_in;
  }
  return is_in;
}

void add_cracks(std::span<BodyGraph> graphs, std::span<const CrackPlan> cracks, CracksOutside outside) {
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    const CrackPlan& crack = cracks[c];
    require_length(crack);
    bool is_there = false;
    for (BodyGraph& graph : graphs) {
      CrackedGraph cracked(graph, cracks.first(c));
      if (!cracked.holds_some_of(crack)) continue;
      cracked.add(crack);
      is_there = true;
    }
    if (!is_there && outside == CracksOutside::are_refused)
      throw InputError(crack.place,
                       fmt::format("expected a crack in a body, found none of it there: ({:.9g}, {:.9g}), …",
                                   crack.along.front().x, crack.along.front().y));
  }
}

std::vector<CrackTip> tips_of(const BodyGraph& graph) {
  if (std::ranges::none_of(graph.pieces, &BodyPiece::is_slit)) return {};
  return SlitEnds(graph).tips();
}

}  // namespace keyblock
