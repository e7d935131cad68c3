// Draws areas first, then edges, then bolts and points, so that nothing hides a smaller thing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/blocks_picture.hpp"

#include <fmt/format.h>

#include <set>
#include <vector>

#include "base/counted.hpp"
#include "report/drawing/colours.hpp"
#include "report/drawing/scene.hpp"
#include "report/drawing/svg.hpp"
#include "report/page.hpp"

namespace keyblock::report {
namespace {

constexpr double kDrawingHeight = 640;
constexpr double kFootHeight = 40;  // scale bar

Box bounds(const Blocks& blocks) {
  Box box;
  for (const BlockPolygon& block : blocks.blocks)
    for (const BlockVertex& vertex : block.outer) box.include(vertex.position);
  return box;
}

std::vector<Point> corners(const BlockLoop& loop) {
  std::vector<Point> points;
  points.reserve(loop.size());
  for (const BlockVertex& vertex : loop) points.push_back(vertex.position);
  return points;
}

void draw_area(SvgPage& page, const PageMap& map, const BlockPolygon& block) {
  std::vector<std::vector<Point>> loops{map(corners(block.outer))};
  for (const BlockLoop& hole : block.holes) loops.push_back(map(corners(hole)));
  page.polygon(loops, {.fill = area_colour(block.material)});
}

void draw_edges(SvgPage& page, const PageMap& map, const BlockLoop& loop, double width) {
  std::vector<int> joints;
  for (const BlockVertex& vertex : loop) joints.push_back(vertex.joint_material);
  draw_joint_edges(page, map(corners(loop)), joints, width);
}

void draw_points(SvgPage& page, const PageMap& map, const std::vector<BlockPoint>& points, Mark mark) {
  for (const BlockPoint& point : points) draw_mark(page, map(point.position), mark);
}

void add_mark(std::vector<LegendEntry>& legend, const std::vector<BlockPoint>& points, Mark mark,
              std::string_view word) {
  if (points.empty()) return;
  legend.push_back({.sign = LegendEntry::Sign::mark,
                    .colour = {},
                    .mark = mark,
                    .words = fmt::format("{} ({})", word, points.size())});
}

BoltState state_of(const BlockBolt& bolt) {
  return bolt.stiffness > 0 || bolt.pretension != 0 ? BoltState::carries : BoltState::idle;
}

std::vector<LegendEntry> make_legend(const Blocks& blocks, const std::vector<std::string>& rock_names,
                                     const std::vector<std::string>& joint_names) {
  std::set<int> materials;
  std::set<int> joints;
  for (const BlockPolygon& block : blocks.blocks) {
    materials.insert(block.material);
    for (const BlockVertex& vertex : block.outer) joints.insert(vertex.joint_material);
    for (const BlockLoop& hole : block.holes)
      for (const BlockVertex& vertex : hole) joints.insert(vertex.joint_material);
  }
  std::vector<LegendEntry> legend;
  add_numbered(legend, materials, LegendEntry::Sign::area, "block material", rock_names);
  add_numbered(legend, joints, LegendEntry::Sign::line, "joint material", joint_names);
  add_mark(legend, blocks.fixed_points, Mark::fixed_point, "fixed points");
  add_mark(legend, blocks.loading_points, Mark::loading_point, "loading points");
  add_mark(legend, blocks.measured_points, Mark::measured_point, "measured points");
  std::vector<BoltState> bolts;
  for (const BlockBolt& bolt : blocks.bolts) bolts.push_back(state_of(bolt));
  add_bolts(legend, bolts);
  return legend;
}

void draw_scene(SvgPage& page, const PageMap& map, const Blocks& blocks) {
  page.layer([&] {
    for (const BlockPolygon& block : blocks.blocks) draw_area(page, map, block);
    const double width = edge_width(map.size(), blocks.blocks.size());
    for (const BlockPolygon& block : blocks.blocks) {
      draw_edges(page, map, block.outer, width);
      for (const BlockLoop& hole : block.holes) draw_edges(page, map, hole, width);
    }
  });
  page.layer([&] {
    for (const BlockBolt& bolt : blocks.bolts)
      draw_bolt(page, map(bolt.segment.start), map(bolt.segment.end), state_of(bolt), bolt.name.value_or({}));
  });
  page.layer([&] {
    draw_points(page, map, blocks.fixed_points, Mark::fixed_point);
    draw_points(page, map, blocks.loading_points, Mark::loading_point);
    draw_points(page, map, blocks.measured_points, Mark::measured_point);
  });
}

/// Writes the numbers of blocks; returns how many blocks are too small for theirs.
std::size_t number_blocks(SvgPage& page, const PageMap& map, const Blocks& blocks) {
  std::vector<NumberedBlock> numbered;
  for (const BlockPolygon& block : blocks.blocks) {
    NumberedBlock& out = numbered.emplace_back(static_cast<int>(numbered.size()) + 1);
    out.loops.push_back(map(corners(block.outer)));
    for (const BlockLoop& hole : block.holes) out.loops.push_back(map(corners(hole)));
  }
  return draw_block_numbers(page, numbered);
}

}  // namespace

std::string blocks_picture(const Blocks& blocks, const Units& units, Numbers numbers,
                           const std::vector<std::string>& rock_names, const std::vector<std::string>& joint_names) {
  const Box box = bounds(blocks);
  Point corner{kMargin, kTitleHeight};
  const Point size = PageMap(box, corner, {kRoom, kDrawingHeight}).size();
  corner.x += (kRoom - size.x) / 2;
  const PageMap map(box, corner, {kRoom, kDrawingHeight});
  const std::vector<LegendEntry> legend = make_legend(blocks, rock_names, joint_names);
  const double foot = kTitleHeight + size.y + 30;  // room for marks at the lower edge
  SvgPage page(kPageWidth, foot + kFootHeight + legend_height(legend, kRoom));
  std::size_t without = 0;
  if (!box.empty()) {
    draw_scene(page, map, blocks);
    if (numbers == Numbers::all) without = number_blocks(page, map, blocks);
  }
  page.text({kMargin, 26}, counted(blocks.blocks.size(), "block") + without_number_in_words(without),
            {.size = 16, .bold = true});
  if (box.empty()) return page.str();
  draw_scale_bar(page, {kMargin, foot}, kRoom, map, units);
  draw_legend(page, {kMargin, foot + 14}, kRoom, legend);
  return page.str();
}

}  // namespace keyblock::report
