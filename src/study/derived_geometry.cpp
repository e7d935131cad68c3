// Cutting, edges, and loops.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/derived_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "cut/cut_blocks.hpp"
#include "formats/dxf.hpp"
#include "geometry/polygon.hpp"

namespace keyblock::study {
namespace {

constexpr double kMaterialLine = 1e-3;  // length over the edge it starts from: it stays within the block

// Left of the middle of the edge that is longest, and short.
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

// An edge between two blocks is one line, with the joint material of the first.
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

Drawing lines_of(const Blocks& blocks) {
  Edges edges;
  edges.drawing.edge_node_ratio = formats::kBlockEdgeNodeRatio;
  edges.drawing.place = blocks.place;
  for (const BlockPolygon& block : blocks.blocks) {
    edges.add(block.outer);
    for (const BlockLoop& hole : block.holes) edges.add(hole);
  }
  Drawing drawing = std::move(edges.drawing);
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

// The loop's edges by the corner they arrive at, as blocks have them.
BlockLoop loop_of(const Cover& cover, const SlotRange& range) {
  BlockLoop loop;
  for (int i = 0; i < range.size; ++i) {
    const auto at = [&](int k) { return cover.loop_vertices[static_cast<std::size_t>(range.first + k)]; };
    const int before = at((i + range.size - 1) % range.size).joint_material;
    loop.push_back({cover.vertices[static_cast<std::size_t>(at(i).slot)], before});
  }
  return loop;
}

std::size_t block_at(const Blocks& blocks, Point point) {
  for (std::size_t i = 0; i < blocks.blocks.size(); ++i)
    if (side(points_of(blocks.blocks[i].outer), point) != Side::outside) return i;
  return blocks.blocks.size();
}

Blocks blocks_of(const Cover& cover) {
  Blocks blocks;
  blocks.place = cover.place;
  std::vector<BlockLoop> holes;
  for (const SlotRange& range : cover.loops) {
    BlockLoop loop = loop_of(cover, range);
    if (area(points_of(loop)) > 0)
      blocks.blocks.push_back({0, std::move(loop), {}});
    else
      holes.push_back(std::move(loop));
  }
  for (BlockLoop& hole : holes)
    if (const std::size_t i = block_at(blocks, hole.front().position); i < blocks.blocks.size())
      blocks.blocks[i].holes.push_back(std::move(hole));
  for (const CoverElement& element : cover.elements) {
    const auto polygon = cover.polygon(element);
    const std::size_t i = block_at(blocks, centroid(std::vector<Point>(polygon.begin(), polygon.end())));
    if (i < blocks.blocks.size()) blocks.blocks[i].material = element.material;
  }
  const auto carry = [&](const std::vector<CoverPoint>& from, std::vector<BlockPoint>& to) {
    for (const CoverPoint& point : from)
      if (const std::size_t i = block_at(blocks, point.position); i < blocks.blocks.size())
        to.push_back({point.position, static_cast<int>(i), point.place});
  };
  carry(cover.fixed_points, blocks.fixed_points);
  carry(cover.loading_points, blocks.loading_points);
  carry(cover.measured_points, blocks.measured_points);
  return blocks;
}

Derivation as_lines(const Blocks& blocks, const std::string& from) {
  Derivation lines{{}, from, {}};
  lines.content.drawing = lines_of(blocks);
  lines.sentence = fmt::format("{} blocks as the {} lines of their edges", blocks.blocks.size(),
                               lines.content.drawing->joints.size());
  return lines;
}

}  // namespace

std::vector<Derivation> derivations(const formats::Content& geometry) {
  std::vector<Derivation> all;
  if (geometry.drawing) {
    Derivation cut{{}, "drawing", {}};
    cut.content.blocks = cut_blocks(*geometry.drawing).blocks;
    cut.sentence = fmt::format("cut into {} blocks", cut.content.blocks->blocks.size());
    all.push_back(std::move(cut));
  }
  if (geometry.blocks) all.push_back(as_lines(*geometry.blocks, "blocks"));
  if (geometry.cover) {
    Derivation loops{{}, "cover", {}};
    loops.content.blocks = blocks_of(*geometry.cover);
    loops.sentence = fmt::format("{} elements as the {} blocks of their loops", geometry.cover->elements.size(),
                                 loops.content.blocks->blocks.size());
    Derivation lines = as_lines(*loops.content.blocks, "cover");
    all.push_back(std::move(loops));
    all.push_back(std::move(lines));
  }
  return all;
}

}  // namespace keyblock::study
