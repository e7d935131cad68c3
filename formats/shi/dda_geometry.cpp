// Reads and writes the native geometry file; the layout is in the header.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/shi/dda_geometry.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>

#include "base/sentences/sentences.hpp"
#include "formats/text/demands.hpp"
#include "formats/text/numbers.hpp"
#include "formats/text/split.hpp"
#include "formats/text/tokens.hpp"

namespace keyblock::formats {
namespace {

/// Parts in which known files differ.
struct Layout {
  int head = 9;  ///< 8: no count of hole points
  int bolt = 7;
  int fixed = 4;

  bool operator==(const Layout&) const = default;
};

/// Counts of the head, and the resulting totals of a layout.
struct Head {
  std::int64_t lines, boundaries, material_lines, bolts, fixed, loading, measured, holes;

  std::int64_t before_fixed(const Layout& layout) const {
    return layout.head + 5 * (lines + material_lines) + layout.bolt * bolts;
  }
  std::int64_t points() const { return loading + measured + holes; }
  std::int64_t total(const Layout& layout) const { return before_fixed(layout) + layout.fixed * fixed + 2 * points(); }
};

std::optional<Head> head_of(std::span<const double> numbers, int head_size) {
  if (numbers.size() < static_cast<std::size_t>(head_size) || !kEdgeNodeRatio.holds(numbers[0])) return std::nullopt;
  std::array<std::int64_t, 8> counts{};
  for (int i = 1; i < head_size; ++i) {
    if (!is_whole(numbers[i]) || numbers[i] < 0) return std::nullopt;
    counts[i - 1] = static_cast<std::int64_t>(numbers[i]);
  }
  return Head{counts[0], counts[1], counts[2], counts[3], counts[4], counts[5], counts[6], counts[7]};
}

/// Checks material numbers, where a wrong layout has coordinates. Precondition: the total fits.
bool materials_are_whole(std::span<const double> numbers, const Head& head, const Layout& layout) {
  for (std::int64_t i = 0; i < head.lines + head.material_lines; ++i)
    if (!is_whole(numbers[layout.head + 5 * i + 4])) return false;
  return true;
}

/// Rejects fixed records of 2 numbers if the first record repeats a point, as records of 4 numbers do.
bool repeats_first_fixed_point(std::span<const double> numbers, const Head& head, const Layout& layout) {
  const std::int64_t at = head.before_fixed(layout);
  if (at + 4 > static_cast<std::int64_t>(numbers.size())) return false;
  return numbers[at] == numbers[at + 2] && numbers[at + 1] == numbers[at + 3];
}

bool fits_variant(std::span<const double> numbers, const Layout& layout) {
  const auto head = head_of(numbers, layout.head);
  if (!head || head->total(layout) != static_cast<std::int64_t>(numbers.size())) return false;
  if (layout.bolt != 7 && head->bolts == 0) return false;
  if (layout.fixed != 4 && (head->fixed == 0 || repeats_first_fixed_point(numbers, *head, layout))) return false;
  return materials_are_whole(numbers, *head, layout);
}

std::optional<Layout> variant_of(std::span<const double> numbers) {
  for (const int head : {9, 8})
    for (const int fixed : {4, 2})
      for (const int bolt : {7, 0, 4, 9}) {
        const Layout layout{head, bolt, fixed};
        if (layout != Layout{} && fits_variant(numbers, layout)) return layout;
      }
  return std::nullopt;
}

/// Returns the number of missing loading, measured and hole points if the file ends cleanly among them; otherwise 0.
std::int64_t points_missing(const Tokens& tokens) {
  const auto head = head_of(tokens.numbers, 9);
  if (!head || tokens.junk()) return 0;
  const std::int64_t lacking = head->total({}) - static_cast<std::int64_t>(tokens.numbers.size());
  const bool ends_among_points = lacking > 0 && lacking % 2 == 0 && lacking <= 2 * head->points();
  return ends_among_points ? lacking / 2 : 0;
}

std::string describe(const Layout& layout) {
  return fmt::format("{}-number head, {} numbers a bolt, {} numbers a fixed record", layout.head, layout.bolt,
                     layout.fixed);
}

Recognition recognise_damaged(const Tokens& tokens) {
  if (tokens.numbers.empty() || !(tokens.numbers[0] > 0 && tokens.numbers[0] < 0.5)) return {};
  return {Recognition::Fit::damaged,
          fmt::format("its first number, {}, can be an edge-node ratio, but the counts do not fit",
                      format_real(tokens.numbers[0]))};
}

Recognition recognise(const Tokens& tokens) {
  using Fit = Recognition::Fit;
  const auto have = static_cast<std::int64_t>(tokens.numbers.size());
  const auto head = head_of(tokens.numbers, 9);
  if (head && head->total({}) == have && materials_are_whole(tokens.numbers, *head, {}))
    return {Fit::exact, fmt::format("9-number head gives {} numbers, the file has {}", have, have)};
  if (const auto variant = variant_of(tokens.numbers))
    return {Fit::variant, fmt::format("{} gives the file's {} numbers", describe(*variant), have)};
  if (const auto missing = points_missing(tokens))
    return {Fit::variant,
            fmt::format("9-number head gives {} numbers, the file ends {} points early", head->total({}), missing)};
  if (head && head->total({}) < have && materials_are_whole(tokens.numbers, *head, {}))
    return {Fit::surplus, fmt::format("9-number head gives {} numbers, the file has {}", head->total({}), have)};
  return recognise_damaged(tokens);
}

Segment next_segment(Cursor& cursor) {
  Segment segment;
  segment.start.x = cursor.next_real("x of the start");
  segment.start.y = cursor.next_real("y of the start");
  segment.end.x = cursor.next_real("x of the end");
  segment.end.y = cursor.next_real("y of the end");
  return segment;
}

Point next_point(Cursor& cursor) {
  const double x = cursor.next_real("x");
  return {x, cursor.next_real("y")};
}

std::vector<JointLine> next_joint_lines(Cursor& cursor, std::size_t count) {
  std::vector<JointLine> lines;
  for (std::size_t i = 0; i < count; ++i) {
    cursor.enter({"line", i + 1, count});
    const Place place = cursor.place();
    const Segment segment = next_segment(cursor);
    lines.push_back({segment, cursor.next_index("the joint material"), place});
  }
  return lines;
}

std::vector<MaterialLine> next_material_lines(Cursor& cursor, std::size_t count) {
  std::vector<MaterialLine> lines;
  for (std::size_t i = 0; i < count; ++i) {
    cursor.enter({"material line", i + 1, count});
    const Place place = cursor.place();
    const Segment segment = next_segment(cursor);
    lines.push_back({segment, cursor.next_index("the block material"), place});
  }
  return lines;
}

BoltLine next_bolt(Cursor& cursor, int numbers) {
  BoltLine bolt;
  bolt.place = cursor.place();
  bolt.segment = next_segment(cursor);
  if (numbers == 9) {
    cursor.next_real("the first block number");
    cursor.next_real("the second block number");
  }
  if (numbers == 4) return bolt;
  bolt.stiffness = cursor.next_real("the stiffness");
  bolt.strength = cursor.next_real("the strength");
  bolt.pretension = cursor.next_real("the pre-tension");
  return bolt;
}

std::vector<BoltLine> next_bolts(Cursor& cursor, std::size_t count, int numbers) {
  std::vector<BoltLine> bolts;
  for (std::size_t i = 0; numbers > 0 && i < count; ++i) {
    cursor.enter({"bolt", i + 1, count});
    bolts.push_back(next_bolt(cursor, numbers));
  }
  return bolts;
}

FixedLine next_fixed_line(Cursor& cursor, int numbers) {
  const Place place = cursor.place();
  if (numbers == 4) return {next_segment(cursor), place};
  const Point point = next_point(cursor);
  return {{point, point}, place};
}

std::vector<FixedLine> next_fixed_lines(Cursor& cursor, std::size_t count, int numbers) {
  std::vector<FixedLine> lines;
  for (std::size_t i = 0; i < count; ++i) {
    cursor.enter({"fixed line", i + 1, count});
    lines.push_back(next_fixed_line(cursor, numbers));
  }
  return lines;
}

/// `present`: number of announced points that the file still holds.
std::vector<MarkedPoint> next_points(Cursor& cursor, std::string_view noun, std::size_t count, std::size_t present) {
  std::vector<MarkedPoint> points;
  points.reserve(std::min(count, present));
  for (std::size_t i = 0; i < std::min(count, present); ++i) {
    cursor.enter({noun, i + 1, count});
    const Place place = cursor.place();
    points.push_back({next_point(cursor), place});
  }
  return points;
}

struct Counts {
  int lines, boundaries, material_lines, bolts, fixed, loading, measured, holes = 0;
};

Counts next_counts(Cursor& cursor, const Layout& layout) {
  Counts counts{};
  counts.lines = cursor.next_count("the number of lines");
  counts.boundaries = cursor.next_count_up_to(counts.lines, "the number of lines", "the number of boundary lines");
  counts.material_lines = cursor.next_count("the number of block-material lines");
  counts.bolts = cursor.next_count("the number of bolts");
  counts.fixed = cursor.next_count("the number of fixed lines");
  counts.loading = cursor.next_count("the number of loading points");
  counts.measured = cursor.next_count("the number of measured points");
  if (layout.head == 9) counts.holes = cursor.next_count("the number of hole points");
  return counts;
}

Warnings layout_warnings(const Layout& layout, const Counts& counts, const Place& place) {
  Warnings warnings;
  if (layout.head == 8)
    warnings.push_back({"hole_count_missing", place, "the head holds no number of hole points; taken as 0"});
  if (layout.bolt == 0) warnings.push_back(warning_of({"bolts_without_data", {{{"bolts", counts.bolts}}}}, place));
  if (layout.bolt == 4)
    warnings.push_back(warning_of({"bolts_without_properties:in_file", {{{"bolts", counts.bolts}}}}, place));
  if (layout.bolt == 9)
    warnings.push_back(warning_of({"bolts_with_block_numbers", {{{"bolts", counts.bolts}}}}, place));
  if (layout.fixed == 2)
    warnings.push_back({"fixed_points_of_two_numbers", place, "fixed records have 2 numbers: taken as points"});
  return warnings;
}

Layout layout_of(const Tokens& tokens) {
  const auto head = head_of(tokens.numbers, 9);
  const bool is_standard = head && head->total({}) == static_cast<std::int64_t>(tokens.numbers.size());
  return is_standard ? Layout{} : variant_of(tokens.numbers).value_or(Layout{});
}

Drawing next_lines(Cursor& cursor, const Layout& layout, const Counts& counts) {
  Drawing drawing;
  drawing.boundary_count = static_cast<std::size_t>(counts.boundaries);
  drawing.joints = next_joint_lines(cursor, static_cast<std::size_t>(counts.lines));
  drawing.material_lines = next_material_lines(cursor, static_cast<std::size_t>(counts.material_lines));
  drawing.bolts = next_bolts(cursor, static_cast<std::size_t>(counts.bolts), layout.bolt);
  drawing.fixed_lines = next_fixed_lines(cursor, static_cast<std::size_t>(counts.fixed), layout.fixed);
  return drawing;
}

Reading read_tokens(const Tokens& tokens, const ReadHint&) {
  const Layout layout = layout_of(tokens);
  const std::int64_t missing = layout == Layout{} ? points_missing(tokens) : 0;
  Cursor cursor(tokens);
  const Place start = cursor.place();
  const double ratio = cursor.next_real("the edge-node ratio", kEdgeNodeRatio);
  const Counts counts = next_counts(cursor, layout);
  Drawing drawing = next_lines(cursor, layout, counts);
  drawing.edge_node_ratio = ratio;
  drawing.place = {tokens.map->file()};
  const auto next_present = [&](std::string_view noun, int announced) {
    const auto count = static_cast<std::size_t>(announced);
    return next_points(cursor, noun, count, missing > 0 ? cursor.numbers_left() / 2 : count);
  };
  drawing.loading_points = next_present("loading point", counts.loading);
  drawing.measured_points = next_present("measured point", counts.measured);
  drawing.hole_points = next_present("hole point", counts.holes);
  Warnings warnings = layout_warnings(layout, counts, start);
  if (missing > 0) warnings.push_back(warning_of({"points_missing", {{{"points", missing}}}}, cursor.place()));
  return {{std::move(drawing), {}, {}}, joined(std::move(warnings), cursor.remainder())};
}

std::string text_of(Point point) {
  return format_real(point.x) + ' ' + format_real(point.y);
}

std::string text_of(const Segment& segment) {
  return text_of(segment.start) + ' ' + text_of(segment.end);
}

std::string text_of(const BoltLine& bolt) {
  return fmt::format("{} {} {} {}\n", text_of(bolt.segment), format_real(bolt.stiffness), format_real(bolt.strength),
                     format_real(bolt.pretension));
}

std::string write(const Content& content) {
  if (!content.drawing) throw std::invalid_argument("a geometry file needs a drawing");
  const Drawing& drawing = *content.drawing;
  std::string text = fmt::format("{}\n{} {}\n{}\n{}\n{}\n{}\n{}\n{}\n", format_real(drawing.edge_node_ratio),
                                 drawing.joints.size(), drawing.boundary_count, drawing.material_lines.size(),
                                 drawing.bolts.size(), drawing.fixed_lines.size(), drawing.loading_points.size(),
                                 drawing.measured_points.size(), drawing.hole_points.size());
  for (const JointLine& line : drawing.joints)
    text += fmt::format("{} {}\n", text_of(line.segment), line.joint_material + 1);
  for (const MaterialLine& line : drawing.material_lines)
    text += fmt::format("{} {}\n", text_of(line.segment), line.block_material + 1);
  for (const BoltLine& bolt : drawing.bolts) text += text_of(bolt);
  for (const FixedLine& line : drawing.fixed_lines) text += text_of(line.segment) + '\n';
  for (const auto* points : {&drawing.loading_points, &drawing.measured_points, &drawing.hole_points})
    for (const MarkedPoint& point : *points) text += text_of(point.position) + '\n';
  return text;
}

}  // namespace

constinit const Format kDdaGeometry{
    .name = "dda-geometry",
    .title = "native DDA geometry (lines to cut blocks from)",
    .read = read_split<read_tokens>,
    .write = write,
    .recognise_numbers = recognise,
    .read_tokens = read_tokens,
    .evidence = "data and public source; bolt records and variants inferred",
    .sample = "0.01\n4 4\n0\n0\n1\n0\n1\n0\n0 0 4 0 1\n4 0 4 1 1\n4 1 0 1 1\n0 1 0 0 1\n1 0.5 1 0.5\n3 0.5\n"};

}  // namespace keyblock::formats
