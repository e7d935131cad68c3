// Builds drawings for the tests of cutting, and compares blocks in any order and from any starting vertex.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/polygon.hpp"
#include "problem/blocks.hpp"
#include "problem/drawing.hpp"

namespace keyblock {

/// Lines numbered as their place, joint materials 0, 1, 2, …
inline Drawing drawing_of(const std::vector<Segment>& lines, double edge_node_ratio = 0.01) {
  Drawing drawing;
  drawing.edge_node_ratio = edge_node_ratio;
  drawing.place = {"drawing", 0, 0};
  for (const Segment& line : lines) {
    const int number = static_cast<int>(drawing.joints.size());
    drawing.joints.push_back({line, number, {"drawing", number + 1, 0}});
  }
  return drawing;
}

/// The four sides of a rectangle, end to end, counter-clockwise from the lower left.
inline std::vector<Segment> rectangle_sides(Point low, Point high) {
  const Point right{high.x, low.y};
  const Point left{low.x, high.y};
  return {{low, right}, {right, high}, {high, left}, {left, low}};
}

inline std::vector<Segment> operator+(std::vector<Segment> a, const std::vector<Segment>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline double area(const BlockPolygon& block) {
  double sum = area(points_of(block.outer));
  for (const BlockLoop& hole : block.holes) sum += area(points_of(hole));
  return sum;
}

inline double total_area(const Blocks& blocks) {
  double sum = 0;
  for (const BlockPolygon& block : blocks.blocks) sum += area(block);
  return sum;
}

/// Returns true if two loops are the same from some starting vertex.
inline bool is_same_loop(const BlockLoop& a, const BlockLoop& b, double tolerance) {
  if (a.size() != b.size()) return false;
  for (std::size_t shift = 0; shift < b.size(); ++shift) {
    std::size_t i = 0;
    while (i < a.size() && distance(a[i].position, b[(i + shift) % b.size()].position) <= tolerance) ++i;
    if (i == a.size()) return true;
  }
  return false;
}

inline bool is_same_block(const BlockPolygon& a, const BlockPolygon& b, double tolerance) {
  if (a.holes.size() != b.holes.size() || !is_same_loop(a.outer, b.outer, tolerance)) return false;
  return std::all_of(a.holes.begin(), a.holes.end(), [&](const BlockLoop& hole) {
    return std::any_of(b.holes.begin(), b.holes.end(),
                       [&](const BlockLoop& other) { return is_same_loop(hole, other, tolerance); });
  });
}

/// Returns the blocks of `a` that `b` lacks.
inline int count_missing(const Blocks& a, const Blocks& b, double tolerance) {
  return static_cast<int>(std::count_if(a.blocks.begin(), a.blocks.end(), [&](const BlockPolygon& block) {
    return std::none_of(b.blocks.begin(), b.blocks.end(),
                        [&](const BlockPolygon& other) { return is_same_block(block, other, tolerance); });
  }));
}

inline bool has_warning(const Warnings& warnings, const std::string& name) {
  return std::any_of(warnings.begin(), warnings.end(), [&](const Warning& w) { return w.name == name; });
}

}  // namespace keyblock
