// Pairs of blocks by their boxes, then by the area they share.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/shared_ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/counted.hpp"
#include "geometry/box_tree.hpp"
#include "geometry/common_area.hpp"
#include "geometry/polygon.hpp"

namespace keyblock {
namespace {

constexpr double kShared = 1e-2;  // of the smaller block
constexpr int kMostPairs = 1000;  // enough to be told
// Products of corners after which the rest is not looked at: walls and slopes take some 30 a corner.
constexpr double kWorkOfCorner = 300;
constexpr double kWorkAtLeast = 1e6;

Loops loops_of(const BlockPolygon& block) {
  Loops loops = {points_of(block.outer)};
  for (const BlockLoop& hole : block.holes) loops.push_back(points_of(hole));
  return loops;
}

double area_of(const Loops& loops) {
  double sum = 0;
  for (const std::vector<Point>& loop : loops) sum += area(loop);
  return sum;
}

std::size_t corners_of(const Loops& loops) {
  std::size_t count = 0;
  for (const std::vector<Point>& loop : loops) count += loop.size();
  return count;
}

struct SharedGround {
  int first = 0;
  int second = 0;
  double share = 0;  ///< of the smaller
  int pairs = 0;
};

SharedGround find_shared(const std::vector<BlockPolygon>& blocks) {
  std::vector<Box> boxes;
  for (const BlockPolygon& block : blocks)
    for (Box& box = boxes.emplace_back(); const BlockVertex& vertex : block.outer) box.add(vertex.position);
  SharedGround found;
  double left = kWorkAtLeast;
  for (const BlockPolygon& block : blocks) left += kWorkOfCorner * static_cast<double>(corners_of(loops_of(block)));
  visit_touching(boxes, 0, [&](int i, int j) {
    const Loops a = loops_of(blocks[static_cast<std::size_t>(i)]);
    const Loops b = loops_of(blocks[static_cast<std::size_t>(j)]);
    left -= static_cast<double>(corners_of(a)) * static_cast<double>(corners_of(b));
    if (left < 0) return false;
    const double smaller = std::min(area_of(a), area_of(b));
    const double share = common_area(a, b) / smaller;
    if (!(smaller > 0) || !(share > kShared)) return true;
    if (found.pairs == 0 || (i == found.first && j < found.second)) found = {i, j, share, found.pairs};
    ++found.pairs;
    return found.pairs < kMostPairs;
  });
  return found;
}

}  // namespace

const Place& place_of(const BlockPolygon& block, const Blocks& blocks) {
  return block.place.line > 0 ? block.place : blocks.place;
}

const Place& place_of(const BlockBolt& bolt, const Blocks& blocks) {
  return bolt.place.line > 0 ? bolt.place : blocks.place;
}

Warnings shared_ground(const Blocks& blocks) {
  const SharedGround found = find_shared(blocks.blocks);
  if (found.pairs == 0) return {};
  const std::string others = found.pairs == 1
                                 ? ""
                                 : fmt::format("; so do {}{}", found.pairs == kMostPairs ? "at least " : "",
                                               counted(static_cast<std::size_t>(found.pairs - 1), "other pair"));
  return {{"blocks_overlap", place_of(blocks.blocks[static_cast<std::size_t>(found.second)], blocks),
           fmt::format("block {} lies in block {} by {:.3g} % of the smaller one{}: contact drives them apart, or lets "
                       "them be",
                       found.second + 1, found.first + 1, 100 * found.share, others)}};
}

std::vector<InputError> misplaced_holes(const Blocks& blocks) {
  std::vector<InputError> errors;
  for (std::size_t i = 0; i < blocks.blocks.size(); ++i) {
    const BlockPolygon& block = blocks.blocks[i];
    const std::vector<Point> outer = points_of(block.outer);
    for (std::size_t h = 0; h < block.holes.size(); ++h) {
      const std::vector<Point> hole = points_of(block.holes[h]);
      const auto out = std::ranges::find_if(hole, [&](Point p) { return side(outer, p) == Side::outside; });
      if (out != hole.end())
        errors.emplace_back(place_of(block, blocks),
                            fmt::format("expected hole {} of block {} within its outer loop, found a corner of it at "
                                        "({:.9g}, {:.9g})",
                                        h + 1, i + 1, out->x, out->y));
      else if (!(area(hole) < 0))
        errors.emplace_back(place_of(block, blocks),
                            fmt::format("expected hole {} of block {} clockwise with an area, found area {:.9g}", h + 1,
                                        i + 1, area(hole)));
    }
  }
  return errors;
}

}  // namespace keyblock
