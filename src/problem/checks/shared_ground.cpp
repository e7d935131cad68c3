// Names the first pair in each warning.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/checks/shared_ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/sentences/sentences.hpp"
#include "geometry/box.hpp"
#include "geometry/polygon.hpp"
#include "geometry/shared_area.hpp"

namespace keyblock {
namespace {

constexpr double kShared = 1e-2;   // per area of the smaller block
constexpr double kRounded = 1e-4;  // per extent of an outline
constexpr double kFolded = 1e-9;   // per extent: an edge this near to the one before comes back along it

Loops loops_of(const BlockPolygon& block) {
  Loops loops = {points_of(block.outer)};
  for (const BlockLoop& hole : block.holes) loops.push_back(points_of(hole));
  return loops;
}

std::string edge_words(const Loops& loops, const LoopEdge& edge) {
  const std::vector<Point>& loop = loops[edge.loop];
  const Point from = loop[edge.edge];
  const Point to = loop[edge.edge + 1 == loop.size() ? 0 : edge.edge + 1];
  return fmt::format("edge {}{} from ({:.9g}, {:.9g}) to ({:.9g}, {:.9g})", edge.edge + 1,
                     edge.loop == 0 ? "" : fmt::format(" of hole {}", edge.loop), from.x, from.y, to.x, to.y);
}

/// Returns the first two edges of which the second comes back along the first: a spike without width.
std::optional<std::pair<LoopEdge, LoopEdge>> first_fold(const Loops& loops, double extent) {
  for (std::size_t l = 0; l < loops.size(); ++l) {
    std::vector<std::size_t> corners;  // each point once
    for (std::size_t i = 0; i < loops[l].size(); ++i)
      if (corners.empty() || !(loops[l][i] == loops[l][corners.back()])) corners.push_back(i);
    while (corners.size() > 1 && loops[l][corners.front()] == loops[l][corners.back()]) corners.pop_back();
    for (std::size_t i = 0; i < corners.size() && corners.size() > 2; ++i) {
      const std::size_t before = corners[(i + corners.size() - 1) % corners.size()];
      const Point tip = loops[l][corners[i]];
      const Point in = tip - loops[l][before];
      const Point out = loops[l][corners[(i + 1) % corners.size()]] - tip;
      const double off = std::abs(cross(in, out)) / std::max(length(in), length(out));
      if (dot(in, out) < 0 && off <= kFolded * extent) return std::pair{LoopEdge{l, before}, LoopEdge{l, corners[i]}};
    }
  }
  return std::nullopt;
}

/// Returns the number, from 1, of a hole that holds a point of hole `h`, or all of it; of equal holes only earlier ones
/// count. Returns 0 without one.
std::size_t hole_around(const BlockPolygon& block, std::size_t h) {
  const std::vector<Point> hole = points_of(block.holes[h]);
  for (std::size_t k = 0; k < block.holes.size(); ++k) {
    if (k == h) continue;
    const std::vector<Point> other = points_of(block.holes[k]);
    const auto is_inside = [&](Point p) { return side(other, p) == Side::inside; };
    const auto is_on = [&](Point p) { return side(other, p) == Side::on_edge; };
    if (std::ranges::any_of(hole, is_inside) || (k < h && std::ranges::all_of(hole, is_on))) return k + 1;
  }
  return 0;
}

void add_crossing(std::vector<InputError>& errors, const Loops& loops, const Place& place, const std::string& whose) {
  Box box;
  for (const std::vector<Point>& loop : loops)
    for (const Point p : loop) box.add(p);
  const auto found = first_crossing(loops, kRounded * std::max(box.size().x, box.size().y));
  if (!found) return;
  errors.emplace_back(
      place, fmt::format("expected edges of {} that do not cross, found {} across {} at ({:.6g}, {:.6g})", whose,
                         edge_words(loops, found->one), edge_words(loops, found->other), found->at.x, found->at.y));
}

void add_fold(std::vector<InputError>& errors, const Loops& loops, const Place& place, const std::string& whose) {
  Box box;
  for (const Point p : loops.front()) box.add(p);
  const auto found = first_fold(loops, std::max(box.size().x, box.size().y));
  if (!found) return;
  errors.emplace_back(place, fmt::format("expected edges of {} that enclose an area, found {} and {}, which comes back "
                                         "along it",
                                         whose, edge_words(loops, found->first), edge_words(loops, found->second)));
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
  Facts facts{{{"percent_of_smaller", 100 * found.share}, {"pairs", found.pairs}},
              {{"at_least", found.pairs == kMostSharedPairs ? "at least " : ""}},
              {found.second + 1, found.first + 1}};
  if (found.pairs > 1) facts.numbers.emplace_back("other_pairs", found.pairs - 1);
  const Place& place = place_of(blocks.blocks[static_cast<std::size_t>(found.second)], blocks);
  return {warning_of({"blocks_overlap", std::move(facts)}, place)};
}

std::vector<InputError> crossed_outlines(const Blocks& blocks) {
  std::vector<InputError> errors;
  for (std::size_t i = 0; i < blocks.blocks.size(); ++i) {
    const Loops loops = loops_of(blocks.blocks[i]);
    const std::string whose = fmt::format("block {} of {}", i + 1, blocks.blocks.size());
    const std::size_t before = errors.size();
    add_crossing(errors, loops, place_of(blocks.blocks[i], blocks), whose);
    if (errors.size() == before) add_fold(errors, loops, place_of(blocks.blocks[i], blocks), whose);
  }
  return errors;
}

std::vector<InputError> crossed_outlines(const Cover& cover) {
  std::vector<InputError> errors;
  for (std::size_t i = 0; i < cover.elements.size(); ++i) {
    const CoverElement& element = cover.elements[i];
    const std::span<const Point> corners = cover.polygon(element);
    if (corners.size() < 4) continue;  // edges of a triangle do not cross
    add_crossing(errors, {{corners.begin(), corners.end()}}, element.place.line > 0 ? element.place : cover.place,
                 fmt::format("element {} of {}", i + 1, cover.elements.size()));
  }
  for (std::size_t i = 0; i < cover.loops.size(); ++i)
    add_crossing(errors, {cover.corners(cover.loops[i])}, cover.place,
                 fmt::format("loop {} of {}", i + 1, cover.loops.size()));
  return errors;
}

std::vector<InputError> crossed_outlines(const std::vector<Stage>& stages) {
  std::vector<InputError> errors;
  for (const Stage& stage : stages)
    for (const StageExcavation& dug : stage.excavations)
      add_crossing(errors, {dug.outline}, dug.place, "the excavation");
  return errors;
}

std::vector<InputError> crossed_outlines(const CoverPlan& plan) {
  std::vector<InputError> errors;
  for (const ExcavationPlan& dug : plan.excavations) add_crossing(errors, {dug.outline}, dug.place, "the excavation");
  return errors;
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
      else if (const std::size_t k = hole_around(block, h); k > 0)
        errors.emplace_back(
            place_of(block, blocks),
            fmt::format("expected holes of block {} that do not overlap, found hole {} in hole {}", i + 1, h + 1, k));
    }
  }
  return errors;
}

}  // namespace keyblock
