// Places numbers in blocks. A text is a rectangle, a square on a stretched plane. It lies inside a block if its middle
// does, and if it is no larger than twice the distance to the nearest edge, the greater of those along both axes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/block_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/polygon.hpp"

namespace keyblock::report {
namespace {

constexpr double kUsualSize = 13;
constexpr double kLeastSize = 4;       // of a page 900 wide: 0.8 mm on a page of 170 mm
constexpr double kDigitHeight = 0.73;  // of the size, in the faces named
constexpr double kRoomAround = 1.15;   // times the text
constexpr int kCells = 8;
constexpr int kRounds = 3;
constexpr std::string_view kNumberFill = "#111111";

using Loops = std::vector<std::vector<Point>>;

/// The greater of the distances along both axes, least over the segment: a convex function of the place on it, linear
/// between those where one of them is 0 or both are equal.
double axis_distance(Point from, Point a, Point b) {
  const Point start = a - from, way = b - a;
  const auto at = [&](double t) {
    const Point p = start + std::clamp(t, 0.0, 1.0) * way;
    return std::max(std::abs(p.x), std::abs(p.y));
  };
  const auto zero_of = [](double value, double slope) { return slope == 0 ? 0.0 : -value / slope; };
  return std::min({at(0), at(1), at(zero_of(start.x, way.x)), at(zero_of(start.y, way.y)),
                   at(zero_of(start.x - start.y, way.x - way.y)), at(zero_of(start.x + start.y, way.x + way.y))});
}

/// Returns the distance, below 0 outside.
double room_about(const Loops& loops, Point p) {
  double room = std::numeric_limits<double>::infinity();
  bool is_inside = false;
  for (const std::vector<Point>& loop : loops) {
    if (side(loop, p) == Side::inside) is_inside = !is_inside;
    for (std::size_t i = 0; i < loop.size(); ++i)
      room = std::min(room, axis_distance(p, loop[i], loop[(i + 1) % loop.size()]));
  }
  return is_inside ? room : -room;
}

struct Best {
  Point at;
  double room = -std::numeric_limits<double>::infinity();

  void look_at(const Loops& loops, Point p) {
    const double found = room_about(loops, p);
    if (found > room) *this = {p, found};
  }
};

}  // namespace

NumberInside largest_inside(const Loops& loops, const std::string& words) {
  if (loops.empty() || loops.front().size() < 3) return {};
  const Point text{kRoomAround * text_width(words, 1), kRoomAround * kDigitHeight};
  Loops stretched = loops;
  Box box;
  for (std::vector<Point>& loop : stretched)
    for (Point& p : loop) {
      p = {p.x / text.x, p.y / text.y};
      box.include(p);
    }
  if (box.empty() || std::min(box.width(), box.height()) < kLeastSize) return {};
  Best best;
  best.look_at(stretched, centroid(stretched.front()));
  Point corner = box.low;
  Point cell{box.width() / kCells, box.height() / kCells};
  for (int round = 0; round < kRounds; ++round) {
    for (int i = 0; i < kCells; ++i)
      for (int j = 0; j < kCells; ++j) best.look_at(stretched, corner + Point{(i + 0.5) * cell.x, (j + 0.5) * cell.y});
    corner = best.at - cell;
    cell = (2.0 / kCells) * cell;
  }
  return {{best.at.x * text.x, best.at.y * text.y}, std::clamp(2 * best.room, 0.0, kUsualSize)};
}

std::size_t draw_block_numbers(SvgPage& page, const std::vector<NumberedBlock>& blocks) {
  std::size_t without = 0;
  for (const NumberedBlock& block : blocks) {
    const std::string words = fmt::format("{}", block.number);
    const NumberInside inside = largest_inside(block.loops, words);
    if (inside.size < kLeastSize) {
      ++without;
      continue;
    }
    page.text(inside.middle + Point{0, kDigitHeight / 2 * inside.size}, words,
              {.size = inside.size, .anchor = Anchor::middle, .fill = kNumberFill});
  }
  return without;
}

std::string without_number_in_words(std::size_t count) {
  if (count == 0) return {};
  return count == 1 ? "; 1 is too small for its number" : fmt::format("; {} are too small for their numbers", count);
}

}  // namespace keyblock::report
