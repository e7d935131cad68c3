// Reads and writes the block file; the layout is in the header.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/shi/dda_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <stdexcept>

#include "base/sentences/sentences.hpp"
#include "formats/shi/edge_convention.hpp"
#include "formats/text/numbers.hpp"
#include "formats/text/split.hpp"
#include "formats/text/tokens.hpp"
#include "geometry/polygon.hpp"

namespace keyblock::formats {
namespace {

constexpr std::int64_t kSpareSlots = 4;  // the repeated first vertex and three of scratch

struct Head {
  std::int64_t blocks = 0, bolts = 0, slots = 0, fixed = 0, loading = 0, measured = 0;

  std::int64_t points() const { return fixed + loading + measured; }
  std::int64_t before_points() const { return 6 + 3 * blocks + 3 * slots + 9 * bolts; }
};

std::optional<Head> head_of(std::span<const double> numbers) {
  if (numbers.size() < 9) return std::nullopt;
  for (int i = 0; i < 9; ++i)
    if (!is_whole(numbers[i]) || numbers[i] < 0) return std::nullopt;
  const auto count = [&](int i) { return static_cast<std::int64_t>(numbers[i]); };
  const Head head{count(0), count(1), count(2), count(3), count(4), count(5)};
  const bool first_block_starts = numbers[7] == 1 && numbers[8] >= 3;
  if (head.blocks < 1 || !first_block_starts) return std::nullopt;
  return head;
}

/// Returns the numbers per point, 4 or 3, from the total; nothing if neither fits.
std::optional<int> point_size(const Head& head, std::size_t numbers) {
  for (const int size : {4, 3})
    if (head.before_points() + size * head.points() == static_cast<std::int64_t>(numbers)) return size;
  return std::nullopt;
}

/// Returns true if the blocks' slot ranges follow each other, as the writer lays them out, and fill the slots.
bool ranges_follow(std::span<const double> numbers, const Head& head) {
  double expected_start = 1;
  for (std::int64_t block = 0; block < head.blocks; ++block) {
    const auto range = numbers.subspan(6 + 3 * block, 3);
    if (range[1] != expected_start || range[2] < range[1] + 2) return false;
    expected_start = range[2] + 1 + kSpareSlots;
  }
  return expected_start == static_cast<double>(head.slots) + 1;
}

Recognition recognise(const Tokens& tokens) {
  using Fit = Recognition::Fit;
  const auto head = head_of(tokens.numbers);
  if (!head) return {};
  const auto size = point_size(*head, tokens.numbers.size());
  const auto have = static_cast<std::int64_t>(tokens.numbers.size());
  if (size && ranges_follow(tokens.numbers, *head))
    return {Fit::exact, fmt::format("6-number head with {} numbers a point gives {} numbers, the file has {}, and the "
                                    "vertex slots of {} blocks follow each other",
                                    *size, have, have, head->blocks)};
  const std::int64_t total = head->before_points() + 4 * head->points();
  const std::string evidence = fmt::format("6-number head gives {} numbers, the file has {}", total, have);
  if (total < have && ranges_follow(tokens.numbers, *head)) return {Fit::surplus, evidence};
  return {Fit::damaged, evidence};
}

struct Range {
  int material = 0;
  int first = 0;  ///< slot, from 0
  int size = 0;
  Place place;
};

std::vector<Range> next_ranges(Cursor& cursor, int blocks, int slots) {
  std::vector<Range> ranges;
  int start = 0;
  for (int i = 0; i < blocks; ++i) {
    cursor.enter({"block", static_cast<std::size_t>(i) + 1, static_cast<std::size_t>(blocks)});
    const Place start_of_row = cursor.place();
    const int material = cursor.next_index("the block material");
    const Place place = cursor.place();
    const int first = cursor.next_index("the first vertex slot");
    const int last = cursor.next_index("the last vertex slot");
    const bool sound = first == start && last >= first + 2 && last <= slots - 1 - kSpareSlots;
    if (!sound)
      throw InputError(place,
                       fmt::format("expected vertex slots of block {} of {} (from {} on, 3 or more, at most {}), "
                                   "found \"{} {}\"",
                                   i + 1, blocks, start + 1, slots - kSpareSlots, first + 1, last + 1));
    ranges.push_back({material, first, last - first + 1, start_of_row});
    start = last + 1 + static_cast<int>(kSpareSlots);
  }
  return ranges;
}

std::vector<BlockVertex> next_slots(Cursor& cursor, int count) {
  std::vector<BlockVertex> slots;
  for (int i = 0; i < count; ++i) {
    cursor.enter({"vertex slot", static_cast<std::size_t>(i) + 1, static_cast<std::size_t>(count)});
    const double material = cursor.next_real("the joint material");
    const double x = cursor.next_real("x");
    const double y = cursor.next_real("y");
    slots.push_back({{x, y}, is_whole(material) ? static_cast<int>(material) - 1 : -1});
  }
  return slots;
}

int next_block_number(Cursor& cursor, int blocks, std::string_view name) {
  if (cursor.numbers_left() > 0) {
    const Place place = cursor.place();
    const int block = cursor.next_integer(name);
    if (block >= 0 && block <= blocks) return block - 1;
    throw InputError(place, fmt::format("expected {} (0 to {}), found \"{}\"", name, blocks, block));
  }
  cursor.fail(name);
}

std::vector<BlockBolt> next_bolts(Cursor& cursor, int count, int blocks) {
  std::vector<BlockBolt> bolts;
  for (int i = 0; i < count; ++i) {
    cursor.enter({"bolt", static_cast<std::size_t>(i) + 1, static_cast<std::size_t>(count)});
    BlockBolt bolt;
    bolt.place = cursor.place();
    bolt.segment.start.x = cursor.next_real("x of the start");
    bolt.segment.start.y = cursor.next_real("y of the start");
    bolt.segment.end.x = cursor.next_real("x of the end");
    bolt.segment.end.y = cursor.next_real("y of the end");
    bolt.first_block = next_block_number(cursor, blocks, "the first block number");
    bolt.second_block = next_block_number(cursor, blocks, "the second block number");
    bolt.stiffness = cursor.next_real("the stiffness");
    bolt.strength = cursor.next_real("the strength");
    bolt.pretension = cursor.next_real("the pre-tension");
    bolts.push_back(bolt);
  }
  return bolts;
}

struct PointLayout {
  int size = 4;
  int blocks = 0;
};

std::vector<BlockPoint> next_points(Cursor& cursor, std::string_view noun, int count, const PointLayout& layout) {
  std::vector<BlockPoint> points;
  for (int i = 0; i < count; ++i) {
    cursor.enter({noun, static_cast<std::size_t>(i) + 1, static_cast<std::size_t>(count)});
    const Place place = cursor.place();
    if (layout.size == 4) cursor.next_real("the point type");
    const double x = cursor.next_real("x");
    const double y = cursor.next_real("y");
    points.push_back({{x, y}, next_block_number(cursor, layout.blocks, "the block number"), place});
  }
  return points;
}

/// Points that the cutting program found in no block have block 0: they are dropped, each with a warning.
Warnings outside_warnings(const std::vector<BlockPoint>& points, std::string_view noun) {
  Warnings warnings;
  for (const BlockPoint& point : points)
    if (point.block < 0) {
      Facts facts{{}, {{"noun", std::string(noun)}}};
      facts.points = {{point.position.x, point.position.y}};
      add_warning(warnings, warning_of({"point_outside_blocks:in_block_0", std::move(facts)}, point.place));
    }
  return warnings;
}

/// A load without a block would be lost, and would shift the curves of the following points: it is an error.
void refuse_outside(const std::vector<BlockPoint>& loading_points) {
  for (const BlockPoint& point : loading_points)
    if (point.block < 0) throw InputError(point.place, "expected a loading point within a block, found one in block 0");
}

/// Only slots of blocks are checked: a fraction there is not a joint material. Other slots may hold any number.
Warnings fraction_warnings(const Tokens& tokens, const Head& head) {
  Warnings warnings;
  for (std::int64_t block = 0; block < head.blocks; ++block) {
    const auto at = static_cast<std::size_t>(6 + 3 * block);
    const auto first = static_cast<std::int64_t>(tokens.numbers[at + 1]) - 1;
    const auto last = static_cast<std::int64_t>(tokens.numbers[at + 2]) - 1;
    for (std::int64_t slot = first; slot <= last; ++slot) {
      const auto material = static_cast<std::size_t>(6 + 3 * head.blocks + 3 * slot);
      const double number = tokens.numbers[material];
      if (is_whole(number)) continue;
      const Facts facts{
          {{"joint_material", number}}, {{"written", format_real(number)}}, {static_cast<int>(block) + 1}};
      add_warning(warnings, warning_of({"joint_material_not_whole", facts}, tokens.place_of(material)));
    }
  }
  return warnings;
}

std::vector<BlockPoint> inside_only(std::vector<BlockPoint> points) {
  std::erase_if(points, [](const BlockPoint& point) { return point.block < 0; });
  return points;
}

std::vector<BlockPolygon> polygons(const std::vector<Range>& ranges, const std::vector<BlockVertex>& slots) {
  std::vector<BlockPolygon> blocks;
  for (const Range& range : ranges) {
    BlockPolygon block;
    block.material = range.material;
    block.place = range.place;
    block.outer.assign(slots.begin() + range.first, slots.begin() + range.first + range.size);
    blocks.push_back(std::move(block));
  }
  return blocks;
}

Warnings bolt_warnings(const std::vector<BlockBolt>& bolts) {
  Warnings warnings;
  for (const BlockBolt& bolt : bolts)
    if (bolt.first_block < 0 || bolt.second_block < 0) {
      const auto& [start, end] = bolt.segment;
      const Facts facts{{}, {}, {}, {{start.x, start.y}, {end.x, end.y}}};
      add_warning(warnings, warning_of({"bolt_outside_blocks", facts}, bolt.place));
    }
  return warnings;
}

Head next_head(Cursor& cursor) {
  const Place start = cursor.place();
  Head head;
  head.blocks = cursor.next_count("the number of blocks");
  if (head.blocks == 0) throw InputError(start, "expected the number of blocks (1 or more), found \"0\"");
  head.bolts = cursor.next_count("the number of bolts");
  head.slots = cursor.next_count("the number of vertex slots");
  head.fixed = cursor.next_count("the number of fixed points");
  head.loading = cursor.next_count("the number of loading points");
  head.measured = cursor.next_count("the number of measured points");
  return head;
}

/// Reads the content unchanged: with points in block 0, and joint materials at their places in the file.
Blocks next_blocks(Cursor& cursor, const Head& head, int point_numbers) {
  const int block_count = static_cast<int>(head.blocks);
  const int slot_count = static_cast<int>(head.slots);
  const std::vector<Range> ranges = next_ranges(cursor, block_count, slot_count);
  const std::vector<BlockVertex> slots = next_slots(cursor, slot_count);
  Blocks blocks;
  blocks.blocks = polygons(ranges, slots);
  blocks.bolts = next_bolts(cursor, static_cast<int>(head.bolts), block_count);
  const PointLayout layout{point_numbers, block_count};
  blocks.fixed_points = next_points(cursor, "fixed point", static_cast<int>(head.fixed), layout);
  blocks.loading_points = next_points(cursor, "loading point", static_cast<int>(head.loading), layout);
  blocks.measured_points = next_points(cursor, "measured point", static_cast<int>(head.measured), layout);
  return blocks;
}

Blocks without_outsiders(Blocks blocks) {
  blocks.fixed_points = inside_only(std::move(blocks.fixed_points));
  blocks.measured_points = inside_only(std::move(blocks.measured_points));
  std::erase_if(blocks.bolts, [](const BlockBolt& bolt) { return bolt.first_block < 0 || bolt.second_block < 0; });
  return blocks;
}

Reading read_tokens(const Tokens& tokens, const ReadHint&) {
  Cursor cursor(tokens);
  const Place start = cursor.place();
  const Head head = next_head(cursor);
  Blocks blocks = next_blocks(cursor, head, point_size(head, tokens.numbers.size()).value_or(4));
  refuse_outside(blocks.loading_points);
  Warnings warnings = joined(fraction_warnings(tokens, head), bolt_warnings(blocks.bolts));
  warnings = joined(std::move(warnings), outside_warnings(blocks.fixed_points, "a fixed point"));
  warnings = joined(std::move(warnings), outside_warnings(blocks.measured_points, "a measured point"));
  blocks = without_outsiders(std::move(blocks));
  if (convention_of(blocks.blocks) == EdgeConvention::leaving) {
    blocks.blocks = with_arriving_edges(std::move(blocks.blocks));
    warnings.push_back({"leaving_edge_materials", start,
                        "blocks agree on shared edges only if each slot holds the joint material of the edge "
                        "that leaves it; "
                        "read so"});
  }
  blocks.place = {tokens.map->file()};
  return {{{}, std::move(blocks), {}}, joined(std::move(warnings), cursor.remainder())};
}

std::string slot_text(int material, double x, double y) {
  return fmt::format("{} {} {}\n", material, format_real(x), format_real(y));
}

std::string slots_text(const BlockLoop& loop) {
  std::string text;
  for (const BlockVertex& vertex : loop)
    text += slot_text(vertex.joint_material + 1, vertex.position.x, vertex.position.y);
  const std::vector<Point> points = points_of(loop);
  const double size = area(points);
  const Point centre = centroid(points);
  double radius = 0;
  for (Point p : points) radius = std::max(radius, distance(p, centre));
  text += slot_text(loop.front().joint_material + 1, loop.front().position.x, loop.front().position.y);
  text += slot_text(0, radius, size);
  text += slot_text(0, size * centre.x, size * centre.y);
  return text + slot_text(0, centre.x, centre.y);
}

std::string bolt_text(const BlockBolt& bolt) {
  const Segment& ends = bolt.segment;
  return fmt::format("{} {} {}\n{} {} {}\n{} {} {}\n", format_real(ends.start.x), format_real(ends.start.y),
                     format_real(ends.end.x), format_real(ends.end.y), bolt.first_block + 1, bolt.second_block + 1,
                     format_real(bolt.stiffness), format_real(bolt.strength), format_real(bolt.pretension));
}

/// `type` absent: points of 3 numbers.
std::string points_text(const std::vector<BlockPoint>& points, std::optional<int> type) {
  std::string text;
  for (const BlockPoint& point : points) {
    if (type) text += fmt::format("{} ", *type);
    text += fmt::format("{} {} {}\n", format_real(point.position.x), format_real(point.position.y), point.block + 1);
  }
  return text;
}

/// Writes all content except the points.
std::string text_before_points(const Content& content) {
  if (!content.blocks) throw std::invalid_argument("a block file needs blocks");
  const Blocks& blocks = *content.blocks;
  std::size_t slots = 0;
  std::string ranges;
  for (const BlockPolygon& block : blocks.blocks) {
    if (block.outer.size() < 3) throw std::invalid_argument("a block file needs blocks of 3 vertices and more");
    ranges += fmt::format("{} {} {}\n", block.material + 1, slots + 1, slots + block.outer.size());
    slots += block.outer.size() + kSpareSlots;
  }
  std::string text =
      fmt::format("{} {} {}\n{} {} {}\n", blocks.blocks.size(), blocks.bolts.size(), slots, blocks.fixed_points.size(),
                  blocks.loading_points.size(), blocks.measured_points.size());
  text += ranges;
  for (const BlockPolygon& block : blocks.blocks) text += slots_text(block.outer);
  for (const BlockBolt& bolt : blocks.bolts) text += bolt_text(bolt);
  return text;
}

std::string write(const Content& content) {
  const std::string text = text_before_points(content);
  const Blocks& blocks = *content.blocks;
  return text + points_text(blocks.fixed_points, 0) + points_text(blocks.loading_points, 2) +
         points_text(blocks.measured_points, 1);
}

std::string write_points_of_three(const Content& content) {
  std::string text = text_before_points(content);
  const Blocks& blocks = *content.blocks;
  for (const auto* points : {&blocks.fixed_points, &blocks.loading_points, &blocks.measured_points})
    text += points_text(*points, std::nullopt);
  return text;
}

}  // namespace

constinit const Format kDdaBlocks{
    .name = "dda-blocks",
    .title = "native block file (blocks after cutting)",
    .read = read_split<read_tokens>,
    .write = write,
    .recognise_numbers = recognise,
    .read_tokens = read_tokens,
    .evidence = "public source",
    .sample = "1 0 8\n1 0 0\n1 1 4\n1 0 0\n1 4 0\n1 4 1\n1 0 1\n1 0 0\n0 2.06 4\n0 8 2\n0 2 0.5\n0 0.5 0.5 1\n"};
constinit const Format kDdaBlocksOfThree{
    .name = "dda-blocks-3",
    .title = "native block file with points of 3 numbers",
    .read = read_split<read_tokens>,
    .write = write_points_of_three,
    .read_tokens = read_tokens,
    .evidence = "comments of public source; never chosen for a file, to write it on request",
    .sample = "1 0 8\n1 0 0\n1 1 4\n1 0 0\n1 4 0\n1 4 1\n1 0 1\n1 0 0\n0 2.06 4\n0 8 2\n0 2 0.5\n0.5 0.5 1\n"};

}  // namespace keyblock::formats
