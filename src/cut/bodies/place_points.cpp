// Places marks of a drawing in blocks by the rules of Shi's block cutter (legacy rules 7 to 9 of cutting); see
// place_points.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/place_points.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/counted.hpp"
#include "base/sentences/sentences.hpp"
#include "base/words/quoted_name.hpp"
#include "geometry/polygon.hpp"
#include "geometry/predicates.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

bool has_vertex_near(const BlockLoop& loop, Point p, double reach) {
  return std::any_of(loop.begin(), loop.end(), [&](const BlockVertex& v) { return distance(v.position, p) <= reach; });
}

bool has_vertex_near(const BlockPolygon& block, Point p, double reach) {
  return has_vertex_near(block.outer, p, reach) ||
         std::any_of(block.holes.begin(), block.holes.end(),
                     [&](const BlockLoop& hole) { return has_vertex_near(hole, p, reach); });
}

/// Calls `visit` with every edge of the block, outer loop first.
template <class Visit>
void visit_edges(const BlockPolygon& block, Visit visit) {
  const auto visit_loop = [&](const BlockLoop& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      visit(Segment{loop[i].position, loop[i + 1 == loop.size() ? 0 : i + 1].position});
    }
  };
  visit_loop(block.outer);
  for (const BlockLoop& hole : block.holes) visit_loop(hole);
}

Point left_normal(const Segment& s) {
  const Point along = s.end - s.start;
  return (1 / length(along)) * Point{-along.y, along.x};
}

/// Adds marks to one set of blocks and records those it could not place.
class Placer {
 public:
  Placer(const CutTolerances& tolerances, Blocks& blocks) : tolerances_(tolerances), blocks_(blocks) {}

  Warnings take_warnings() { return std::move(warnings_); }

  /// Returns the numbers of the blocks that stay.
  std::vector<int> remove_holes(const std::vector<MarkedPoint>& hole_points) {
    std::vector<char> is_hole(blocks_.blocks.size(), 0);
    for (const MarkedPoint& mark : hole_points) {
      if (const auto block = block_at(blocks_.blocks, mark.position, tolerances_.vertex_catch))
        is_hole[static_cast<std::size_t>(*block)] = 1;
      else
        outside_.push_back({"hole point", mark.position, mark.place});
    }
    std::vector<int> kept;
    for (std::size_t i = 0; i < is_hole.size(); ++i) {
      if (is_hole[i]) continue;
      if (kept.size() != i) blocks_.blocks[kept.size()] = std::move(blocks_.blocks[i]);
      kept.push_back(static_cast<int>(i));
    }
    blocks_.blocks.resize(kept.size());
    return kept;
  }

  void set_material(const MaterialLine& line) {
    const std::optional<int> first = block_at(blocks_.blocks, line.segment.start, tolerances_.vertex_catch);
    bool has_met = first.has_value();
    if (first) blocks_.blocks[*first].material = line.block_material;
    const bool is_point = line.segment.start == line.segment.end;
    for (BlockPolygon& block : blocks_.blocks) {
      if (is_point) break;
      bool is_crossed = false;
      visit_edges(block, [&](const Segment& edge) { is_crossed |= meeting(line.segment, edge) != Meeting::none; });
      if (is_crossed) block.material = line.block_material;
      has_met |= is_crossed;
    }
    if (!has_met) outside_.push_back({"material line", line.segment.start, line.place});
  }

  void add_fixed(const FixedLine& line) {
    const std::size_t before = blocks_.fixed_points.size();
    if (line.segment.start != line.segment.end) add_fixed_crossings(line);
    if (blocks_.fixed_points.size() > before) return crossing_lines_.push_back(&line);
    add_point(blocks_.fixed_points, "fixed point", {line.segment.start, line.place});
    if (line.segment.start == line.segment.end || blocks_.fixed_points.size() == before) return;
    Facts facts{{}, {}, {blocks_.fixed_points.back().block + 1}, ends_of(line.segment)};
    warn({"fixed_line_in_one_block", std::move(facts)}, line.place);
  }

  /// Warns of blocks in which a fixed line ends and whose only fixed point is the one where it leaves them. Call it
  /// after all fixed lines are placed.
  void warn_of_single_points() {
    std::vector<int> held(blocks_.blocks.size());
    for (const BlockPoint& point : blocks_.fixed_points) ++held[point.block];
    Facts facts;
    Place first;
    for (const FixedLine* line : crossing_lines_)
      for (const Point end : {line->segment.start, line->segment.end}) {
        const auto block = block_at(blocks_.blocks, end, tolerances_.vertex_catch);
        if (!block || held[*block] != 1) continue;
        if (facts.elements.empty()) first = line->place;
        facts.elements.push_back(*block + 1);
        facts.points.push_back({end.x, end.y});
      }
    if (facts.elements.empty()) return;
    facts.numbers = {{"count", facts.elements.size()}};
    const char* const form =
        facts.elements.size() == 1 ? "fixed_line_ends_in_block" : "fixed_line_ends_in_block:several";
    warn({form, std::move(facts)}, first);
  }

  void add_point(std::vector<BlockPoint>& list, std::string_view kind, const MarkedPoint& mark) {
    if (const auto at = find(kind, mark.position, mark.place)) list.push_back({at->nearest, at->block, mark.place});
  }

  void add_bolt(const BoltLine& bolt) {
    const auto first = find("bolt end", bolt.segment.start, bolt.place);
    const auto second = find("bolt end", bolt.segment.end, bolt.place);
    if (!first || !second) return;
    if (first->block == second->block) idle_bolts_.push_back(&bolt);
    blocks_.bolts.push_back({{first->nearest, second->nearest},
                             first->block,
                             second->block,
                             bolt.stiffness,
                             bolt.strength,
                             bolt.pretension,
                             bolt.place,
                             bolt.name});
  }

  // Loads belong to loading points by order: without this point its load would act on the next one.
  void add_loading(const MarkedPoint& mark) {
    const auto at = find("loading point", mark.position, mark.place);
    if (!at)
      throw InputError(mark.place,
                       fmt::format("expected a loading point inside a block, found ({}, {}) outside all blocks",
                                   mark.position.x, mark.position.y));
    blocks_.loading_points.push_back({at->nearest, at->block, mark.place});
  }

  /// Issues one warning per kind, with the count and the first point. Call it after all marks are placed.
  void warn_of_points() {
    if (!outside_.empty())
      warn({outside_.size() == 1 ? "point_outside_blocks" : "point_outside_blocks:several", facts_of(outside_)},
           outside_.front().place);
    if (!moved_.empty()) {
      Facts facts = facts_of(moved_);
      facts.numbers.emplace_back("within", reach());
      facts.texts.emplace_back("are", moved_.size() == 1 ? "is" : "are");
      warn({"points_moved", std::move(facts)}, moved_.front().place);
    }
    if (idle_bolts_.empty()) return;
    const BoltLine& first = *idle_bolts_.front();
    Facts facts{{{"count", idle_bolts_.size()}}, {{"named", quoted_name(first.name.value_or({}))}}};
    facts.points = ends_of(first.segment);
    if (first.name) facts.names = {{"bolt", *first.name}};
    warn({idle_bolts_.size() == 1 ? "bolt_in_one_block" : "bolt_in_one_block:several", std::move(facts)}, first.place);
  }

 private:
  void add_fixed_crossings(const FixedLine& line) {
    for (std::size_t i = 0; i < blocks_.blocks.size(); ++i) {
      visit_edges(blocks_.blocks[i], [&](const Segment& edge) {
        if (meeting(line.segment, edge) != Meeting::crossing) return;
        const Point at = point_at(edge, station(edge, line.segment).value);
        const Point inside = at + tolerances_.inset * left_normal(edge);
        blocks_.fixed_points.push_back({inside, static_cast<int>(i), line.place});
      });
    }
  }

  struct Mark {
    std::string_view kind;
    Point position;
    Place place;
  };

  double reach() const { return std::max(tolerances_.merge, tolerances_.vertex_catch); }

  /// Returns the block of a point and the place where the point is put. A point outside by round-off keeps its place.
  std::optional<BlockBeside> find(std::string_view kind, Point p, const Place& place) {
    if (const auto block = block_at(blocks_.blocks, p, tolerances_.vertex_catch)) return BlockBeside{*block, p};
    auto beside = block_beside(blocks_.blocks, p, reach());
    if (!beside) {
      outside_.push_back({kind, p, place});
    } else if (distance(beside->nearest, p) <= tolerances_.round_off) {
      beside->nearest = p;
    } else {
      moved_.push_back({kind, p, place});
    }
    return beside;
  }

  void warn(Finding finding, const Place& place) { warnings_.push_back(warning_of(std::move(finding), place)); }

  static std::vector<std::array<double, 2>> ends_of(const Segment& s) {
    return {{s.start.x, s.start.y}, {s.end.x, s.end.y}};
  }

  /// Returns the count and the places of marks.
  static Facts facts_of(const std::vector<Mark>& marks) {
    Facts facts{{{"count", marks.size()}}, {{"kinds", kinds_of(marks)}, {"noun", std::string(marks.front().kind)}}};
    for (const Mark& mark : marks) facts.points.push_back({mark.position.x, mark.position.y});
    return facts;
  }

  /// Returns the counts by kind, such as "3 points (2 × bolt end, 1 × fixed point)".
  static std::string kinds_of(const std::vector<Mark>& marks) {
    std::vector<std::string_view> kinds;
    for (const Mark& mark : marks)
      if (std::ranges::find(kinds, mark.kind) == kinds.end()) kinds.push_back(mark.kind);
    std::vector<std::string> counts;
    for (const std::string_view kind : kinds)
      counts.push_back(fmt::format("{} × {}", std::ranges::count(marks, kind, &Mark::kind), kind));
    return fmt::format("{} ({})", counted(marks.size(), "mark"), fmt::join(counts, ", "));
  }

  const CutTolerances& tolerances_;
  Blocks& blocks_;
  std::vector<const FixedLine*> crossing_lines_;
  std::vector<const BoltLine*> idle_bolts_;  ///< both ends in one block
  std::vector<Mark> outside_;
  std::vector<Mark> moved_;
  Warnings warnings_;
};

}  // namespace

bool holds(const BlockPolygon& block, Point p) {
  if (side(points_of(block.outer), p) == Side::outside) return false;
  return std::none_of(block.holes.begin(), block.holes.end(),
                      [&](const BlockLoop& hole) { return side(points_of(hole), p) == Side::inside; });
}

std::optional<int> block_at(const std::vector<BlockPolygon>& blocks, Point p, double vertex_catch) {
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (has_vertex_near(blocks[i], p, vertex_catch)) return static_cast<int>(i);
  }
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (holds(blocks[i], p)) return static_cast<int>(i);
  }
  return std::nullopt;
}

std::optional<BlockBeside> block_beside(const std::vector<BlockPolygon>& blocks, Point p, double reach) {
  std::optional<BlockBeside> found;
  double least = reach;
  for (std::size_t i = 0; i < blocks.size(); ++i)
    visit_edges(blocks[i], [&](const Segment& edge) {
      const Point nearest = point_at(edge, std::clamp(foot(edge, p), 0.0, 1.0));
      const double gap = distance(nearest, p);
      if (gap > least || (found && gap == least)) return;
      least = gap;
      found = {static_cast<int>(i), nearest};
    });
  return found;
}

PlacedMarks place_marks(const Drawing& drawing, const CutTolerances& tolerances, Blocks& blocks) {
  Placer placer(tolerances, blocks);
  PlacedMarks placed;
  placed.kept = placer.remove_holes(drawing.hole_points);
  for (const MaterialLine& line : drawing.material_lines) placer.set_material(line);
  for (const FixedLine& line : drawing.fixed_lines) placer.add_fixed(line);
  placer.warn_of_single_points();
  for (const MarkedPoint& p : drawing.loading_points) placer.add_loading(p);
  for (const MarkedPoint& p : drawing.measured_points) placer.add_point(blocks.measured_points, "measured point", p);
  for (const BoltLine& bolt : drawing.bolts) placer.add_bolt(bolt);
  placer.warn_of_points();
  placed.warnings = placer.take_warnings();
  return placed;
}

}  // namespace keyblock
