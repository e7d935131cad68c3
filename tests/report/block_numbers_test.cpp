// Numbers are inside their blocks, as large as possible; those of slivers are left out and counted.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/block_numbers.hpp"

#include <gtest/gtest.h>

#include <random>

#include "geometry/polygon.hpp"

namespace keyblock::report::block_numbers_test {
namespace {

constexpr double kDigits = 0.73;  // height of digits over the size of the face

/// Points of the outline of the text, all of which must lie inside.
std::vector<Point> outline_of(const NumberInside& inside, const std::string& words) {
  const double half_width = text_width(words, inside.size) / 2, half_height = kDigits * inside.size / 2;
  std::vector<Point> points;
  for (int i = -10; i <= 10; ++i)
    for (const double side : {-1.0, 1.0}) {
      points.push_back(inside.middle + Point{i / 10.0 * half_width, side * half_height});
      points.push_back(inside.middle + Point{side * half_width, i / 10.0 * half_height});
    }
  return points;
}

std::vector<Point> rectangle(double width, double height) {
  return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

}  // namespace

// Corners on random rays about a middle: convex and not.
TEST(BlockNumbers, they_lie_inside_blocks_of_any_shape) {
  std::mt19937 dice(7);
  std::uniform_real_distribution<double> radius(5, 60);
  int drawn = 0;
  for (int shape = 0; shape < 200; ++shape) {
    std::vector<Point> loop;
    const int corners = 3 + shape % 6;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * 3.14159265358979 * i / corners, r = radius(dice);
      loop.push_back({100 + r * std::cos(angle), 100 + r * std::sin(angle)});
    }
    const std::string words = std::to_string(1 + shape * 7);
    const NumberInside inside = largest_inside({loop}, words);
    if (inside.size == 0) continue;
    ++drawn;
    for (const Point p : outline_of(inside, words)) EXPECT_NE(side(loop, p), Side::outside) << shape;
  }
  EXPECT_GT(drawn, 150);
}

TEST(BlockNumbers, they_are_of_the_usual_size_where_there_is_room_and_fill_a_narrow_block) {
  EXPECT_DOUBLE_EQ(largest_inside({rectangle(100, 100)}, "12").size, 13);
  // Number in a strip as high as 8 the digits, 0.73 of the size, with 15 % around them.
  EXPECT_NEAR(largest_inside({rectangle(100, 8)}, "12").size, 8 / (1.15 * kDigits), 0.02);
  EXPECT_LT(largest_inside({rectangle(100, 1)}, "12").size, 4);
  EXPECT_EQ(largest_inside({{{0, 0}, {1, 1}}}, "12").size, 0);
}

TEST(BlockNumbers, a_hole_in_the_middle_is_passed_by) {
  const std::vector<Point> hole{{20, 20}, {20, 80}, {80, 80}, {80, 20}};
  const NumberInside inside = largest_inside({rectangle(100, 100), hole}, "5");
  EXPECT_GT(inside.size, 8);
  for (const Point p : outline_of(inside, "5")) EXPECT_EQ(side(hole, p), Side::outside);
}

TEST(BlockNumbers, those_too_small_are_counted_and_said) {
  SvgPage page(200, 200);
  const std::size_t without =
      draw_block_numbers(page, {{1, {rectangle(50, 50)}}, {22, {rectangle(50, 1)}}, {333, {rectangle(1, 50)}}});
  EXPECT_EQ(without, 2U);
  const std::string svg = page.str();
  EXPECT_NE(svg.find(">1</text>"), std::string::npos) << svg;
  EXPECT_EQ(svg.find(">22</text>"), std::string::npos);
  EXPECT_EQ(without_number_in_words(without), "; 2 are too small for their numbers");
  EXPECT_EQ(without_number_in_words(1), "; 1 is too small for its number");
  EXPECT_EQ(without_number_in_words(0), "");
}

}  // namespace keyblock::report::block_numbers_test
