// Cuts the bodies by the outlines, which count as joints with materials of their own, and drops the enclosed parts.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/excavate.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "cut/bodies/block_shape.hpp"
#include "cut/bodies/cut_blocks.hpp"
#include "cut/bodies/place_points.hpp"
#include "geometry/polygon.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

// Joint material of outline 0; outline i has this number less i. No joint of a file has such a material.
constexpr int kOutline = std::numeric_limits<int>::max();

// Merging distance of edges of blocks over the scale of the drawing: rounding of outlines that run along them. Without
// it an edge that is turned leaves a hair of rock along the wall, and contacts there are nonsense.
constexpr double kOutlineRounding = 1e-9;

/// Returns the new number of every body that stays, -1 for the others. Appends the materials to `materials`.
std::vector<int> numbers_of_rest(const std::vector<BlockPolygon>& bodies, const std::vector<Region>& regions,
                                 const Blocks* blocks, std::vector<int>& materials) {
  std::vector<int> numbers;
  for (const BlockPolygon& body : bodies) {
    const std::optional<Point> inside = point_inside(loops_of(body));
    if (!inside) {
      numbers.push_back(-1);
      continue;
    }
    const bool is_gone =
        std::ranges::any_of(regions, [&](const Region& r) { return side(r.outline, *inside) == Side::inside; });
    const BlockPolygon* owner = &body;
    if (blocks != nullptr) {
      const auto found = std::ranges::find_if(blocks->blocks, [&](const auto& block) { return holds(block, *inside); });
      owner = found == blocks->blocks.end() ? nullptr : &*found;  // lies in a hole of the blocks
    }
    numbers.push_back(is_gone || owner == nullptr ? -1 : static_cast<int>(materials.size()));
    if (numbers.back() >= 0) materials.push_back(owner->material);
  }
  return numbers;
}

}  // namespace

Drawing lines_of(const Blocks& blocks) {
  Drawing drawing;
  drawing.place = blocks.place;
  drawing.edge_node_ratio = kOutlineRounding;
  const auto add = [&](const BlockLoop& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const BlockVertex& next = loop[(i + 1) % loop.size()];
      drawing.joints.push_back({{loop[i].position, next.position}, next.joint_material, blocks.place});
    }
  };
  for (const BlockPolygon& block : blocks.blocks) {
    add(block.outer);
    for (const BlockLoop& hole : block.holes) add(hole);
  }
  return drawing;
}

BodyGraph excavated(const Drawing& drawing, const std::vector<Region>& regions, NodeMerging merging,
                    const Blocks* blocks) {
  Drawing cut = drawing;
  cut.edge_node_ratio = std::max(cut.edge_node_ratio, kOutlineRounding);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const std::vector<Point>& outline = regions[r].outline;
    for (std::size_t i = 0; i < outline.size(); ++i)
      cut.joints.push_back(
          {{outline[i], outline[(i + 1) % outline.size()]}, kOutline - static_cast<int>(r), drawing.place});
  }
  BodyCut bodies = cut_bodies(cut, merging);
  BodyGraph rest;
  rest.nodes = std::move(bodies.graph.nodes);
  const std::vector<int> numbers = numbers_of_rest(bodies.blocks.blocks.blocks, regions, blocks, rest.materials);
  if (rest.materials.empty()) throw InputError(drawing.place, "expected a body that is not excavated, found none");
  const auto renumbered = [&](int body) { return body < 0 ? -1 : numbers[static_cast<std::size_t>(body)]; };
  for (BodyPiece piece : bodies.graph.pieces) {
    piece.left = renumbered(piece.left);
    piece.right = renumbered(piece.right);
    const bool is_outline = piece.joint_material > kOutline - static_cast<int>(regions.size());
    if (is_outline)
      piece.joint_material = regions[static_cast<std::size_t>(kOutline - piece.joint_material)].joint_material;
    const bool bounds_nothing = piece.left < 0 && piece.right < 0;
    if (piece.is_slit ? !is_outline : !bounds_nothing) rest.pieces.push_back(piece);
  }
  return rest;
}

}  // namespace keyblock
