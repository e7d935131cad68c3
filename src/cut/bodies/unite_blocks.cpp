// Cancels sides that run against each other, then links the remaining sides to loops.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/unite_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/polygon.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

// Limit below which a corner is straight: twice the area that the corner adds, over the square of the chord. It covers
// the round-off of crossings, far below the accuracy required of areas.
constexpr double kStraightShare = 1e-12;

struct DirectedSide {
  int from = 0;
  int to = 0;
  int joint_material = 0;
  int line = -1;  ///< of the drawing; negative without one
  bool is_gone = false;
};

/// Corner with the line of the side that arrives there.
struct LinedCorner {
  BlockVertex vertex;
  int line = -1;
};

class Uniting {
 public:
  Uniting(const DrawnBlock& first, const DrawnBlock& second, double tolerance)
      : first_(first), second_(second), tolerance_(tolerance) {}

  std::optional<UnitedBlocks> run() {
    std::vector<DirectedSide> one = sides_of(first_, 0);
    const std::size_t own = nodes_.size();
    std::vector<DirectedSide> other = sides_of(second_, own);
    one = split(one);
    other = split(other);
    const double shared = cancel(one, other);
    if (!(shared > tolerance_)) return std::nullopt;
    for (std::vector<DirectedSide>* sides : {&one, &other})
      std::ranges::copy_if(*sides, std::back_inserter(left_), [](const DirectedSide& side) { return !side.is_gone; });
    std::optional<DrawnBlock> block = linked();
    if (!block) return std::nullopt;
    return UnitedBlocks{std::move(*block), shared};
  }

 private:
  /// Returns the node at p. `foreign`: number of leading nodes that belong to the other block; near corners join these.
  int node_of(Point p, std::size_t foreign) {
    std::size_t nearest = nodes_.size();
    for (std::size_t i = 0; i < foreign; ++i)
      if (distance(nodes_[i], p) <= tolerance_ &&
          (nearest == nodes_.size() || distance(nodes_[i], p) < distance(nodes_[nearest], p)))
        nearest = i;
    for (std::size_t i = foreign; i < nodes_.size() && nearest == nodes_.size(); ++i)
      if (nodes_[i] == p) nearest = i;
    if (nearest == nodes_.size()) nodes_.push_back(p);
    return static_cast<int>(nearest);
  }

  std::vector<DirectedSide> sides_of(const DrawnBlock& block, std::size_t foreign) {
    std::vector<DirectedSide> sides;
    std::size_t corner = 0;
    const auto add = [&](const BlockLoop& loop) {
      std::vector<int> nodes;
      for (const BlockVertex& vertex : loop) nodes.push_back(node_of(vertex.position, foreign));
      for (std::size_t i = 0; i < loop.size(); ++i, ++corner)
        sides.push_back({nodes[(i + loop.size() - 1) % loop.size()], nodes[i], loop[i].joint_material,
                         block.lines.empty() ? -1 : block.lines[corner]});
    };
    add(block.polygon.outer);
    for (const BlockLoop& hole : block.polygon.holes) add(hole);
    std::erase_if(sides, [](const DirectedSide& side) { return side.from == side.to; });
    return sides;
  }

  Point at(int node) const { return nodes_[static_cast<std::size_t>(node)]; }

  // Splits the sides at the nodes that lie on them.
  std::vector<DirectedSide> split(const std::vector<DirectedSide>& sides) const {
    std::vector<DirectedSide> pieces;
    for (const DirectedSide& side : sides) {
      const Segment segment{at(side.from), at(side.to)};
      const double slack = tolerance_ / distance(segment.start, segment.end);
      std::vector<std::pair<double, int>> stops;
      for (int node = 0; node < static_cast<int>(nodes_.size()); ++node) {
        const double t = foot(segment, at(node));
        if (node != side.from && node != side.to && t > slack && t < 1 - slack &&
            distance_to_carrier(segment, at(node)) <= tolerance_)
          stops.emplace_back(t, node);
      }
      std::ranges::sort(stops);
      DirectedSide piece = side;
      for (const auto& [t, node] : stops) {
        piece.to = node;
        pieces.push_back(piece);
        piece.from = node;
      }
      piece.to = side.to;
      pieces.push_back(piece);
    }
    return pieces;
  }

  double cancel(std::vector<DirectedSide>& one, std::vector<DirectedSide>& other) const {
    double shared = 0;
    for (DirectedSide& side : one)
      for (DirectedSide& against : other) {
        if (side.is_gone || against.is_gone || side.from != against.to || side.to != against.from) continue;
        side.is_gone = against.is_gone = true;
        shared += distance(at(side.from), at(side.to));
      }
    return shared;
  }

  // Returns the next side of the same sector of rock: the first clockwise from the reversed side.
  std::size_t next(std::size_t side, const std::vector<char>& is_used) const {
    const Point back = at(left_[side].from) - at(left_[side].to);
    std::size_t best = left_.size();
    double least = 0;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      if (is_used[i] || left_[i].from != left_[side].to) continue;
      const Point ahead = at(left_[i].to) - at(left_[i].from);
      double angle = std::atan2(cross(ahead, back), dot(ahead, back));
      if (angle <= 0) angle += 2 * std::numbers::pi;
      if (best == left_.size() || angle < least) best = i, least = angle;
    }
    return best;
  }

  std::optional<DrawnBlock> linked() const {
    std::vector<std::vector<LinedCorner>> loops;
    std::vector<char> is_used(left_.size(), 0);
    for (std::size_t start = 0; start < left_.size(); ++start) {
      if (is_used[start]) continue;
      std::vector<LinedCorner> loop;
      for (std::size_t side = start;;) {
        is_used[side] = 1;
        loop.push_back({{at(left_[side].to), left_[side].joint_material}, left_[side].line});
        if (left_[side].to == left_[start].from) break;
        side = next(side, is_used);
        if (side == left_.size()) return std::nullopt;
      }
      loop = without_straight(std::move(loop));
      if (loop.size() >= 3) loops.push_back(std::move(loop));
    }
    return block_of(std::move(loops));
  }

  static std::vector<LinedCorner> without_straight(std::vector<LinedCorner> loop) {
    for (std::size_t i = 0; i < loop.size() && loop.size() >= 3;) {
      const Point a = loop[(i + loop.size() - 1) % loop.size()].vertex.position;
      const LinedCorner& here = loop[i];
      const LinedCorner& after = loop[(i + 1) % loop.size()];
      const Point b = here.vertex.position;
      const Point c = after.vertex.position;
      const bool is_straight =
          std::abs(cross(b - a, c - a)) <= kStraightShare * dot(c - a, c - a) && dot(b - a, c - b) > 0;
      if (is_straight && here.vertex.joint_material == after.vertex.joint_material)
        loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
      else
        ++i;
    }
    return loop;
  }

  std::optional<DrawnBlock> block_of(std::vector<std::vector<LinedCorner>> loops) const {
    const auto area_of_loop = [](const std::vector<LinedCorner>& loop) {
      std::vector<Point> points;
      for (const LinedCorner& corner : loop) points.push_back(corner.vertex.position);
      return area(points);
    };
    const auto outer = std::ranges::max_element(loops, {}, area_of_loop);
    const auto is_outer = [&](const std::vector<LinedCorner>& loop) { return area_of_loop(loop) > 0; };
    if (std::ranges::count_if(loops, is_outer) != 1) return std::nullopt;
    std::iter_swap(loops.begin(), outer);
    DrawnBlock block;
    block.polygon.material = first_.polygon.material;
    block.polygon.place = first_.polygon.place;
    for (const std::vector<LinedCorner>& corners : loops) {
      BlockLoop loop;
      for (const LinedCorner& corner : corners) {
        loop.push_back(corner.vertex);
        if (corner.line >= 0) block.lines.push_back(corner.line);
      }
      if (&corners == &loops.front())
        block.polygon.outer = std::move(loop);
      else
        block.polygon.holes.push_back(std::move(loop));
    }
    return block;
  }

  const DrawnBlock& first_;
  const DrawnBlock& second_;
  double tolerance_;
  std::vector<Point> nodes_;
  std::vector<DirectedSide> left_;
};

}  // namespace

std::optional<UnitedBlocks> united(const DrawnBlock& first, const DrawnBlock& second, double tolerance) {
  return Uniting(first, second, tolerance).run();
}

}  // namespace keyblock
