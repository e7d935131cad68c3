// The first pair names the warning.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/shared_ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/counted.hpp"
#include "geometry/polygon.hpp"
#include "geometry/shared_area.hpp"

namespace keyblock {
namespace {

constexpr double kShared = 1e-2;  // of the smaller block
Loops loops_of(const BlockPolygon& block) {
  Loops loops = {points_of(block.outer)};
  for (const BlockLoop& hole : block.holes) loops.push_back(points_of(hole));
  return loops;
}

}  // namespace

const Place& place_of(const BlockPolygon& block, const Blocks& blocks) {
  return block.place.line > 0 ? block.place : blocks.place;
}

const Place& place_of(const BlockBolt& bolt, const Blocks& blocks) {
  return bolt.place.line > 0 ? bolt.place : blocks.place;
}

Warnings shared_ground(const Blocks& blocks) {
  std::vector<Loops> bodies;
  for (const BlockPolygon& block : blocks.blocks) bodies.push_back(loops_of(block));
  const SharedArea found = shared_area(bodies, kShared);
  if (found.pairs == 0 && !found.is_complete)
    return {{"overlaps_not_looked_for", blocks.place,
             "blocks have so many corners close to one another that not all were looked at for overlaps"}};
  if (found.pairs == 0) return {};
  const std::string others = found.pairs == 1
                                 ? ""
                                 : fmt::format("; so do {}{}", found.pairs == kMostSharedPairs ? "at least " : "",
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
