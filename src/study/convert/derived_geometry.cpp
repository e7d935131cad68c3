// Derives geometry by cutting, from edges, or from loops.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/convert/derived_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/sentences/sentences.hpp"
#include "cut/bodies/cut_blocks.hpp"
#include "cut/bodies/place_points.hpp"
#include "formats/dxf/dxf.hpp"
#include "geometry/polygon.hpp"

namespace keyblock::study {
namespace {

constexpr double kMaterialLine = 1e-3;  // length over its base edge: the line stays within the block

// Returns a short segment left of the middle of the longest edge.
Segment inner_segment(const BlockLoop& outer) {
  std::size_t longest = 0;
  const auto edge = [&](std::size_t i) { return Segment{outer[i].position, outer[(i + 1) % outer.size()].position}; };
  const auto size = [&](std::size_t i) { return distance(edge(i).start, edge(i).end); };
  for (std::size_t i = 1; i < outer.size(); ++i)
    if (size(i) > size(longest)) longest = i;
  const Segment base = edge(longest);
  const Point along = base.end - base.start;
  const Point inward = kMaterialLine * Point{-along.y, along.x};
  const Point middle = base.start + 0.5 * along + inward;
  return {middle, middle + kMaterialLine * along};
}

// Edges of blocks as lines. An edge between two blocks is one line, with the joint material of the first.
class Edges {
 public:
  void add(const BlockLoop& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const BlockVertex& to = loop[(i + 1) % loop.size()];
      const Point a = loop[i].position, b = to.position;
      if (!known_.emplace(std::minmax(key(a), key(b)), 0).second) continue;
      drawing.joints.push_back({{a, b}, to.joint_material, {}});
    }
  }
  Drawing drawing;

 private:
  using Key = std::pair<double, double>;
  static Key key(Point p) { return {p.x, p.y}; }
  std::map<std::pair<Key, Key>, int> known_;
};

struct Extent {
  Point low, high;
  bool has(Point p) const { return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y; }
};

Extent extent_of(const BlockPolygon& block) {
  Extent extent{block.outer.front().position, block.outer.front().position};
  for (const BlockVertex& vertex : block.outer) {
    const Point p = vertex.position;
    extent = {{std::min(extent.low.x, p.x), std::min(extent.low.y, p.y)},
              {std::max(extent.high.x, p.x), std::max(extent.high.y, p.y)}};
  }
  return extent;
}

std::vector<std::vector<Point>> loops_of(const BlockPolygon& block) {
  std::vector<std::vector<Point>> loops{points_of(block.outer)};
  for (const BlockLoop& hole : block.holes) loops.push_back(points_of(hole));
  return loops;
}

// Returns points in voids enclosed by the edges, which cutting would turn into blocks.
std::vector<MarkedPoint> voids_within(const Drawing& edges, const Blocks& blocks) {
  std::vector<Extent> extents;
  for (const BlockPolygon& block : blocks.blocks) extents.push_back(extent_of(block));
  const auto is_filled = [&](Point p) {
    for (std::size_t i = 0; i < extents.size(); ++i)
      if (extents[i].has(p) && holds(blocks.blocks[i], p)) return true;
    return false;
  };
  std::vector<MarkedPoint> voids;
  for (const BlockPolygon& face : cut_blocks(edges).blocks.blocks)
    if (const auto inside = point_inside(loops_of(face)); inside && !is_filled(*inside)) voids.push_back({*inside, {}});
  return voids;
}

Drawing lines_of(const Blocks& blocks) {
  Edges edges;
  edges.drawing.edge_node_ratio = formats::kBlockEdgeNodeRatio;
  edges.drawing.place = blocks.place;
  for (const BlockPolygon& block : blocks.blocks) {
    edges.add(block.outer);
    for (const BlockLoop& hole : block.holes) edges.add(hole);
  }
  Drawing drawing = std::move(edges.drawing);
  drawing.hole_points = voids_within(drawing, blocks);
  for (const BlockPolygon& block : blocks.blocks)
    if (block.material != 0) drawing.material_lines.push_back({inner_segment(block.outer), block.material, {}});
  for (const BlockBolt& bolt : blocks.bolts)
    drawing.bolts.push_back({bolt.segment, bolt.stiffness, bolt.strength, bolt.pretension, 0, {}});
  for (const BlockPoint& point : blocks.fixed_points)
    drawing.fixed_lines.push_back({{point.position, point.position}, point.place});
  for (const BlockPoint& point : blocks.loading_points) drawing.loading_points.push_back({point.position, point.place});
  for (const BlockPoint& point : blocks.measured_points)
    drawing.measured_points.push_back({point.position, point.place});
  return drawing;
}

// Returns the loop's edges by their end corners, as in blocks.
BlockLoop loop_of(const Cover& cover, const SlotRange& range) {
  BlockLoop loop;
  for (int i = 0; i < range.size; ++i) {
    const auto at = [&](int k) { return cover.loop_vertices[static_cast<std::size_t>(range.first + k)]; };
    const int before = at((i + range.size - 1) % range.size).joint_material;
    loop.push_back({cover.vertices[static_cast<std::size_t>(at(i).slot)], before});
  }
  return loop;
}

// Blocks from the loops of a cover. Points find their blocks by position; elements give theirs the material.
class BlocksOfCover {
 public:
  explicit BlocksOfCover(const Cover& cover) : cover_(cover) { blocks_.place = cover.place; }

  Derivation make() {
    add_loops();
    set_materials();
    carry("fixed point", cover_.fixed_points, blocks_.fixed_points);
    for (const CoverPoint& point : cover_.loading_points) add_loading(point);
    carry("measured point", cover_.measured_points, blocks_.measured_points);
    const std::string sentence =
        fmt::format("{} elements as the {} blocks of their loops", cover_.elements.size(), blocks_.blocks.size());
    Derivation derivation{{}, "cover", sentence, std::move(warnings_)};
    derivation.content.blocks = std::move(blocks_);
    return derivation;
  }

 private:
  std::optional<std::size_t> block_at(Point point) const {
    for (std::size_t i = 0; i < blocks_.blocks.size(); ++i)
      if (side(points_of(blocks_.blocks[i].outer), point) != Side::outside) return i;
    return std::nullopt;
  }

  void add_loops() {
    std::vector<BlockLoop> holes;
    for (const SlotRange& range : cover_.loops) {
      BlockLoop loop = loop_of(cover_, range);
      if (area(points_of(loop)) > 0)
        blocks_.blocks.push_back({0, std::move(loop), {}});
      else
        holes.push_back(std::move(loop));
    }
    for (BlockLoop& hole : holes) {
      const Point first = hole.front().position;
      if (const auto block = block_at(first))
        blocks_.blocks[*block].holes.push_back(std::move(hole));
      else
        warn_outside("loop of a hole", first, cover_.place);
    }
  }

  void set_materials() {
    std::set<std::size_t> known, mixed;
    for (const CoverElement& element : cover_.elements) {
      const auto polygon = cover_.polygon(element);
      const auto block = block_at(centroid(polygon));
      if (!block) continue;
      int& material = blocks_.blocks[*block].material;
      if (known.insert(*block).second)
        material = element.material;
      else if (material != element.material)
        mixed.insert(*block);
    }
    if (const std::size_t count = mixed.size(); count > 0)
      warnings_.push_back(
          warning_of({"one_material_a_block", {{{"count", count}, {"blocks", blocks_.blocks.size()}}}}, cover_.place));
  }

  void carry(std::string_view noun, const std::vector<CoverPoint>& from, std::vector<BlockPoint>& to) {
    for (const CoverPoint& point : from)
      if (const auto block = block_at(point.position))
        to.push_back({point.position, static_cast<int>(*block), point.place});
      else
        warn_outside(noun, point.position, point.place);
  }

  void add_loading(const CoverPoint& point) {
    const auto block = block_at(point.position);
    if (!block)
      throw InputError(point.place, fmt::format("expected a loading point inside a block, found ({}, {}) outside all "
                                                "loops of the cover",
                                                point.position.x, point.position.y));
    blocks_.loading_points.push_back({point.position, static_cast<int>(*block), point.place});
  }

  void warn_outside(std::string_view noun, Point at, const Place& place) {
    Facts facts{{}, {{"noun", std::string(noun)}}};
    facts.points = {{at.x, at.y}};
    add_warning(warnings_, warning_of({"point_outside_blocks", std::move(facts)}, place));
  }

  const Cover& cover_;
  Blocks blocks_;
  Warnings warnings_;
};

}  // namespace

std::optional<Derivation> as_blocks(const formats::Content& geometry) {
  if (geometry.cover) return BlocksOfCover(*geometry.cover).make();
  if (!geometry.drawing) return std::nullopt;
  CutResult cut = cut_blocks(*geometry.drawing);
  Derivation derivation{
      {}, "drawing", fmt::format("cut into {} blocks", cut.blocks.blocks.size()), std::move(cut.warnings)};
  derivation.content.blocks = std::move(cut.blocks);
  return derivation;
}

std::optional<Derivation> as_lines(const formats::Content& geometry) {
  Derivation lines{{}, "blocks", {}, {}};
  const Blocks* blocks = geometry.blocks ? &*geometry.blocks : nullptr;
  std::optional<Derivation> loops;
  if (geometry.cover) {
    loops = as_blocks(geometry);
    lines.from = loops->from;
    lines.warnings = std::move(loops->warnings);
    blocks = &*loops->content.blocks;
  }
  if (blocks == nullptr) return std::nullopt;
  lines.content.drawing = lines_of(*blocks);
  lines.sentence = fmt::format("{} blocks as the {} lines of their edges", blocks->blocks.size(),
                               lines.content.drawing->joints.size());
  return lines;
}

}  // namespace keyblock::study
