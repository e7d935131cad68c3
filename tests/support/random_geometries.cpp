// Draws geometries part by part.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/random_geometries.hpp"

#include <algorithm>
#include <numeric>

#include "tests/support/random_values.hpp"

namespace keyblock::support::drawn {

using formats::Content;

Drawing drawing(Dice& dice) {
  Drawing d;
  d.edge_node_ratio = dice.between(0.0001, 0.4);
  d.joints = some(dice, 9, [](Dice& one) { return JointLine{any_segment(one), one.below(12), {}}; });
  if (dice.happens(0.3)) {
    const std::vector<Point> outline = polygon(dice);
    for (std::size_t i = 0; i < outline.size(); ++i)
      d.joints.push_back({{outline[i], outline[(i + 1) % outline.size()]}, dice.below(12), {}});
  }
  d.boundary_count = static_cast<std::size_t>(dice.below(static_cast<int>(d.joints.size()) + 1));
  d.material_lines = some(dice, 3, [](Dice& one) { return MaterialLine{any_segment(one), one.below(5), {}}; });
  d.fixed_lines = some(dice, 4, [](Dice& one) { return FixedLine{any_segment(one), {}}; });
  d.loading_points = some(dice, 3, mark);
  d.measured_points = some(dice, 3, mark);
  d.hole_points = some(dice, 3, mark);
  return d;
}

Content native_drawing(Dice& dice) {
  Content content;
  content.drawing = drawing(dice);
  content.drawing->bolts = some(dice, 3, [](Dice& one) {
    const Segment ends = any_segment(one);
    const double stiffness = positive_real(one), strength = any_real(one);
    return BoltLine{ends, stiffness, strength, any_real(one), 0, {}};
  });
  return content;
}

BlockPolygon block(Dice& dice) {
  BlockPolygon block;
  block.material = dice.below(4);
  for (const Point& point : polygon(dice)) block.outer.push_back({point, dice.below(6)});
  return block;
}

Content blocks(Dice& dice) {
  Content content;
  content.blocks.emplace();
  std::vector<BlockPolygon>& all = content.blocks->blocks;
  all = some(dice, 6, block);
  all.push_back(block(dice));
  const int count = static_cast<int>(all.size());
  const auto carried = [&](Dice& one) {
    const Point position = any_point(one);
    return BlockPoint{position, one.below(count), {}};
  };
  content.blocks->bolts = some(dice, 2, [&](Dice& one) {
    BlockBolt bolt{any_segment(one), one.below(count), 0, 0, 0, 0};
    bolt.second_block = one.below(count);
    bolt.stiffness = positive_real(one);
    bolt.strength = any_real(one);
    bolt.pretension = any_real(one);
    return bolt;
  });
  content.blocks->fixed_points = some(dice, 4, carried);
  content.blocks->loading_points = some(dice, 3, carried);
  content.blocks->measured_points = some(dice, 3, carried);
  return content;
}

/// Elements over slots in an order of their own; loops run around elements drawn at random.
Content cover(Dice& dice) {
  Content content;
  Cover& cover = content.cover.emplace();
  cover.nodes = some(dice, 9, any_point);
  while (cover.nodes.size() < 3) cover.nodes.push_back(any_point(dice));
  const int count = 1 + dice.below(8);
  for (int i = 0; i < count; ++i) {
    CoverElement element{};
    const std::vector<Point> corners = polygon(dice);
    element.vertices = {static_cast<int>(cover.vertices.size()), static_cast<int>(corners.size())};
    element.material = dice.below(5) - 1;
    for (int& node : element.covers) node = dice.below(static_cast<int>(cover.nodes.size()));
    cover.vertices.insert(cover.vertices.end(), corners.begin(), corners.end());
    cover.vertices.push_back(corners.front());
    cover.elements.push_back(element);
  }
  std::rotate(cover.elements.begin(), cover.elements.begin() + dice.below(count), cover.elements.end());
  for (int loops = dice.below(4); loops > 0; --loops) {
    const SlotRange around = cover.elements[static_cast<std::size_t>(dice.below(count))].vertices;
    cover.loops.push_back({static_cast<int>(cover.loop_vertices.size()), around.size});
    for (int i = 0; i <= around.size; ++i)
      cover.loop_vertices.push_back({around.first + i % around.size, dice.below(4)});
  }
  const auto carried = [&](Dice& one) {
    const Point position = any_point(one);
    return CoverPoint{position, one.below(count), {}};
  };
  cover.fixed_points = some(dice, 4, carried);
  cover.loading_points = some(dice, 3, carried);
  cover.measured_points = some(dice, 3, carried);
  return content;
}

}  // namespace keyblock::support::drawn
