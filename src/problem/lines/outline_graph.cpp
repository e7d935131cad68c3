// Finds nodes by cells, pieces by a grid over nodes, and loops by walking; see outline_graph.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/lines/outline_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "geometry/box.hpp"
#include "geometry/segment.hpp"
#include "problem/lines/segment_grid.hpp"

namespace keyblock {
namespace {

constexpr double kSameEnd = 1e-9;              // per extent
constexpr std::size_t kMostTries = 5'000'000;  // points beside lines that are tested
constexpr double kUlps = 64;  // per greatest coordinate: a drawing far from the origin has fewer digits

/// Gives one number to points nearer than a distance.
class PointNumbers {
 public:
  explicit PointNumbers(double same) : same_(same), cell_(std::max(2 * same, 1e-300)) {}

  int number(Point p) {
    const auto [column, row] = Cell{std::llround(p.x / cell_), std::llround(p.y / cell_)};
    for (long long c = column - 1; c <= column + 1; ++c)
      for (long long r = row - 1; r <= row + 1; ++r) {
        const auto found = cells_.find({c, r});
        if (found == cells_.end()) continue;
        for (const int i : found->second)
          if (distance(points_[static_cast<std::size_t>(i)], p) <= same_) return i;
      }
    points_.push_back(p);
    cells_[{column, row}].push_back(static_cast<int>(points_.size()) - 1);
    return static_cast<int>(points_.size()) - 1;
  }

  std::vector<Point> take() { return std::move(points_); }

 private:
  using Cell = std::pair<long long, long long>;
  double same_;
  double cell_;
  std::vector<Point> points_;
  std::map<Cell, std::vector<int>> cells_;
};

}  // namespace

OutlineGraph::OutlineGraph(std::span<const JointLine> lines) {
  find_nodes(lines);
  make_pieces(lines);
  link();
}

void OutlineGraph::find_nodes(std::span<const JointLine> lines) {
  Box box;
  for (const JointLine& line : lines)
    for (const Point p : {line.segment.start, line.segment.end}) box.add(p);
  if (lines.empty()) return;
  const double greatest =
      std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  same_ = std::max(kSameEnd * std::max(box.size().x, box.size().y),
                   kUlps * std::numeric_limits<double>::epsilon() * greatest);
  PointNumbers numbers(same_);
  for (const JointLine& line : lines) {
    const int start = numbers.number(line.segment.start);
    ends_.emplace_back(start, numbers.number(line.segment.end));
  }
  nodes_ = numbers.take();
}

void OutlineGraph::make_pieces(std::span<const JointLine> lines) {
  std::vector<Segment> points;
  for (const Point p : nodes_) points.push_back({p, p});
  SegmentGrid grid(points, same_);
  std::set<std::pair<int, int>> met;
  std::size_t tries = 0;
  for (std::size_t line = 0; line < lines.size(); ++line) {
    const auto [start, end] = ends_[line];
    const Segment& segment = lines[line].segment;
    std::vector<std::pair<double, int>> stops{{0, start}, {1, end}};
    const std::vector<int>& beside = grid.near(segment, static_cast<int>(nodes_.size()));
    tries += beside.size();
    if (tries > kMostTries) {
      is_tangled_ = true;
      pieces_.clear();
      return;
    }
    for (const int node : beside) {
      const Point p = nodes_[static_cast<std::size_t>(node)];
      if (node == start || node == end || distance(segment, p) > same_) continue;
      stops.emplace_back(foot(segment, p), node);
    }
    std::ranges::sort(stops);
    for (std::size_t i = 1; i < stops.size(); ++i) {
      const auto [low, high] = std::minmax(stops[i - 1].second, stops[i].second);
      if (low != high && met.insert({low, high}).second)
        pieces_.push_back({stops[i - 1].second, stops[i].second, line});
    }
  }
}

void OutlineGraph::link() {
  at_.resize(nodes_.size());
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    for (const int node : {pieces_[i].from, pieces_[i].to})
      at_[static_cast<std::size_t>(node)].push_back(static_cast<int>(i));
}

std::vector<Segment> OutlineGraph::pieces() const {
  std::vector<Segment> found;
  for (const Piece& piece : pieces_)
    found.push_back({nodes_[static_cast<std::size_t>(piece.from)], nodes_[static_cast<std::size_t>(piece.to)]});
  return found;
}

std::optional<OutlineFault> OutlineGraph::fault() const {
  std::vector<std::size_t> faults;
  for (std::size_t node = 0; node < nodes_.size(); ++node)
    if (!at_[node].empty() && at_[node].size() != 2) faults.push_back(node);
  if (faults.empty()) return std::nullopt;
  const auto is_open = [&](std::size_t node) { return at_[node].size() == 1; };
  const auto first = std::ranges::find_if(faults, is_open);
  const std::size_t node = first == faults.end() ? faults.front() : *first;
  const Point at = nodes_[node];
  OutlineFault fault{pieces_[static_cast<std::size_t>(at_[node].front())].line, at, at_[node].size(), std::nullopt};
  for (const std::size_t other : faults)
    if (other != node && (!fault.nearest || distance(nodes_[other], at) < distance(*fault.nearest, at)))
      fault.nearest = nodes_[other];
  return fault;
}

std::vector<Outline> OutlineGraph::loops() const {
  std::vector<Outline> loops;
  std::vector<bool> is_used(pieces_.size(), false);
  for (std::size_t first = 0; first < pieces_.size(); ++first) {
    if (is_used[first]) continue;
    Outline loop;
    int node = pieces_[first].from;
    for (std::size_t piece = first; !is_used[piece];) {
      is_used[piece] = true;
      loop.push_back(nodes_[static_cast<std::size_t>(node)]);
      node = pieces_[piece].from == node ? pieces_[piece].to : pieces_[piece].from;
      const std::vector<int>& here = at_[static_cast<std::size_t>(node)];
      piece = static_cast<std::size_t>(static_cast<std::size_t>(here.front()) == piece ? here.back() : here.front());
    }
    if (loop.size() > 2) loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace keyblock
