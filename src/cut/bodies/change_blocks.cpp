// Cuts each block alone by the lines near it, then hands its points and bolts to its pieces.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/change_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "cut/bodies/block_shape.hpp"
#include "cut/bodies/cut_blocks.hpp"
#include "cut/bodies/excavate.hpp"
#include "cut/bodies/place_points.hpp"
#include "geometry/box.hpp"
#include "geometry/polygon.hpp"

namespace keyblock {
namespace {

// Thickness of the thinnest piece kept, per size of its block (square root of the area). Thinner pieces come from
// outlines drawn along edges of blocks. As blocks they would be crushed, neighbours would pass through them, and they
// would set every contact tolerance.
constexpr double kThinnest = 5e-3;

// Distance of a point from a piece, per size of the block, that is rounding of the cut. Such a point belongs to the
// rock that stays: the end of a bolt at the wall of an excavation is one.
constexpr double kOnEdge = 1e-9;

Box box_of(const BlockPolygon& block) {
  Box box;
  for (const BlockVertex& vertex : block.outer) box.add(vertex.position);
  return box;
}

Box box_of(const Segment& segment) {
  Box box;
  box.add(segment.start);
  box.add(segment.end);
  return box;
}

bool meet(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

std::optional<Point> inside_of(const BlockPolygon& block) {
  return point_inside(loops_of(block));
}

/// Returns twice the area over the circumference: the width of a strip, half the width of a square.
double thickness(const BlockPolygon& block) {
  double circumference = 0;
  for (const std::vector<Point>& loop : loops_of(block))
    for (std::size_t i = 0; i < loop.size(); ++i) circumference += distance(loop[i], loop[(i + 1) % loop.size()]);
  return 2 * area_of(block) / circumference;
}

/// Returns the pieces into which the lines cut one block, without slivers, or the block itself if nothing cuts it.
std::vector<BlockPolygon> pieces_of(const BlockPolygon& block, std::span<const JointLine> lines, const Place& place) {
  Blocks alone;
  alone.place = place;
  alone.blocks.push_back(block);
  Drawing drawing = lines_of(alone);
  const std::size_t edges = drawing.joints.size();
  const Box box = box_of(block);
  for (const JointLine& line : lines)
    if (meet(box, box_of(line.segment))) drawing.joints.push_back(line);
  if (drawing.joints.size() == edges) return {block};
  const double thinnest = kThinnest * std::sqrt(area_of(block));
  std::vector<BlockPolygon> pieces;
  for (BlockPolygon& piece : cut_blocks(drawing).blocks.blocks) {
    const std::optional<Point> inside = inside_of(piece);
    if (!inside || !holds(block, *inside) || thickness(piece) < thinnest) continue;
    piece.material = block.material;
    piece.place = block.place;
    pieces.push_back(std::move(piece));
  }
  if (pieces.size() < 2) return {block};
  std::ranges::stable_sort(pieces, std::greater<>{}, [](const BlockPolygon& piece) { return area_of(piece); });
  return pieces;
}

/// Collects the changed blocks one by one, then hands over their points and bolts.
class Handover {
 public:
  explicit Handover(const Blocks& before) : before_(before) {
    changed_.blocks.place = before.place;
    families_.resize(before.blocks.size());
  }

  void add(std::size_t parent, BlockPolygon block) {
    families_[parent].kept.push_back(static_cast<int>(changed_.blocks.blocks.size()));
    changed_.parents.push_back(static_cast<int>(parent));
    changed_.blocks.blocks.push_back(std::move(block));
  }

  /// Takes a piece that is excavated.
  void drop(std::size_t parent, BlockPolygon block) { families_[parent].gone.push_back(std::move(block)); }

  ChangedBlocks finish() && {
    points(before_.fixed_points, changed_.blocks.fixed_points, changed_.fixed_points);
    points(before_.loading_points, changed_.blocks.loading_points, changed_.loading_points);
    points(before_.measured_points, changed_.blocks.measured_points, changed_.measured_points);
    bolts();
    return std::move(changed_);
  }

 private:
  /// Pieces of an earlier block.
  struct Family {
    std::vector<int> kept;
    std::vector<BlockPolygon> gone;
  };

  /// Returns the piece of block `parent` that holds the point, or else is the nearest; nothing if that piece is gone. A
  /// point may lie outside its block: that of a fixed line is inset from the edge that the line crosses, and beyond the
  /// next edge of a sharp corner.
  std::optional<int> heir(int parent, Point p) const {
    const Family& family = families_[static_cast<std::size_t>(parent)];
    if (family.kept.size() == 1 && family.gone.empty()) return family.kept.front();
    std::vector<BlockPolygon> kept;
    for (const int child : family.kept) {
      kept.push_back(changed_.blocks.blocks[static_cast<std::size_t>(child)]);
      if (holds(kept.back(), p)) return child;
    }
    constexpr double kAnywhere = std::numeric_limits<double>::infinity();
    const auto beside = block_beside(kept, p, kAnywhere);
    if (!beside) return std::nullopt;
    const double gap = distance(beside->nearest, p);
    const bool is_on_it = gap <= kOnEdge * std::sqrt(area_of(before_.blocks[static_cast<std::size_t>(parent)]));
    const auto other = block_beside(family.gone, p, kAnywhere);
    const auto is_around = [&](const BlockPolygon& piece) { return holds(piece, p); };
    const bool is_nearer_to_gone = other && distance(other->nearest, p) < gap;
    if (!is_on_it && (is_nearer_to_gone || std::ranges::any_of(family.gone, is_around))) return std::nullopt;
    return family.kept[static_cast<std::size_t>(beside->block)];
  }

  void points(const std::vector<BlockPoint>& before, std::vector<BlockPoint>& after, std::vector<int>& numbers) const {
    for (std::size_t i = 0; i < before.size(); ++i) {
      const std::optional<int> found = heir(before[i].block, before[i].position);
      if (!found) continue;
      after.emplace_back(before[i]).block = *found;
      numbers.push_back(static_cast<int>(i));
    }
  }

  void bolts() {
    for (std::size_t i = 0; i < before_.bolts.size(); ++i) {
      const BlockBolt& bolt = before_.bolts[i];
      const std::optional<int> first = heir(bolt.first_block, bolt.segment.start);
      const std::optional<int> second = heir(bolt.second_block, bolt.segment.end);
      if (!first || !second) continue;
      BlockBolt& kept = changed_.blocks.bolts.emplace_back(bolt);
      kept.first_block = *first;
      kept.second_block = *second;
      changed_.bolts.push_back(static_cast<int>(i));
    }
  }

  const Blocks& before_;
  ChangedBlocks changed_;
  std::vector<Family> families_;  ///< per earlier block
};

bool is_within(const BlockPolygon& piece, std::span<const Region> regions) {
  const std::optional<Point> inside = inside_of(piece);
  return inside && std::ranges::any_of(
                       regions, [&](const Region& region) { return side(region.outline, *inside) == Side::inside; });
}

}  // namespace

ChangedBlocks without_regions(const Blocks& blocks, std::span<const Region> regions) {
  std::vector<JointLine> lines;
  for (const Region& region : regions)
    for (std::size_t i = 0; i < region.outline.size(); ++i)
      lines.push_back(
          {{region.outline[i], region.outline[(i + 1) % region.outline.size()]}, region.joint_material, blocks.place});
  Handover handover(blocks);
  for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
    for (BlockPolygon& piece : pieces_of(blocks.blocks[b], lines, blocks.place))
      if (is_within(piece, regions))
        handover.drop(b, std::move(piece));
      else
        handover.add(b, std::move(piece));
  return std::move(handover).finish();
}

ChangedBlocks cut_along(const Blocks& blocks, std::span<const JointLine> lines) {
  Handover handover(blocks);
  for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
    for (BlockPolygon& piece : pieces_of(blocks.blocks[b], lines, blocks.place)) handover.add(b, std::move(piece));
  return std::move(handover).finish();
}

}  // namespace keyblock
