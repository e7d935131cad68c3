// A far origin changes neither area nor centroid; containment is decided at vertices and edges too.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polygon.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace keyblock::polygon_test {
namespace {

// An L: the unit square's upper right quarter is missing.
const std::vector<Point> kEll = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

std::vector<Point> shifted(std::vector<Point> loop, Point by) {
  for (Point& p : loop) p = p + by;
  return loop;
}

}  // namespace

TEST(Polygon, area_is_positive_counter_clockwise) {
  EXPECT_EQ(area(kEll), 3);
  EXPECT_EQ(area(std::vector<Point>(kEll.rbegin(), kEll.rend())), -3);
  EXPECT_EQ(area(std::vector<Point>{}), 0);
}

TEST(Polygon, a_shift_by_ten_million_leaves_area_and_centroid_as_they_are) {
  const Point far{1e7, -1e7};
  EXPECT_EQ(area(shifted(kEll, far)), 3);
  const Point c = centroid(shifted(kEll, far)) - far;
  EXPECT_NEAR(c.x, 5.0 / 6, 2e-9) << "one unit in the last place of 1e7";
  EXPECT_NEAR(c.y, 5.0 / 6, 2e-9);
}

TEST(Polygon, centroid_of_a_flat_loop_is_the_mean_of_its_vertices) {
  EXPECT_EQ(centroid(std::vector<Point>{{0, 0}, {1, 1}, {2, 2}}), (Point{1, 1}));
}

TEST(Polygon, containment_is_right_level_with_vertices) {
  EXPECT_EQ(side(kEll, {0.5, 1}), Side::inside) << "level with the inner corner";
  EXPECT_EQ(side(kEll, {-1, 1}), Side::outside);
  EXPECT_EQ(side(kEll, {-1, 0}), Side::outside) << "level with an edge";
  EXPECT_EQ(side(kEll, {1.5, 1.5}), Side::outside);
  EXPECT_EQ(side(kEll, {3, 2}), Side::outside);
  const std::vector<Point> diamond = {{1, 0}, {2, 1}, {1, 2}, {0, 1}};
  EXPECT_EQ(side(diamond, {1, 1}), Side::inside) << "level with two vertices";
  EXPECT_EQ(side(diamond, {-1, 1}), Side::outside);
  EXPECT_EQ(side(diamond, {-1, 2}), Side::outside);
}

TEST(Polygon, edges_and_vertices_are_neither_inside_nor_outside) {
  for (const Point p : {Point{0, 0}, Point{1, 0}, Point{2, 0.5}, Point{1, 1}, Point{1.5, 1}, Point{0, 2}}) {
    EXPECT_EQ(side(kEll, p), Side::on_edge) << p.x << " " << p.y;
    EXPECT_EQ(side(std::vector<Point>(kEll.rbegin(), kEll.rend()), p), Side::on_edge);
  }
}

namespace {

std::string crossing_words(const std::vector<std::vector<Point>>& loops, double least = 1e-4) {
  const auto found = first_crossing(loops, least);
  if (!found) return "";
  return std::to_string(found->one.loop) + ":" + std::to_string(found->one.edge) + " " +
         std::to_string(found->other.loop) + ":" + std::to_string(found->other.edge);
}

std::vector<Point> turned(std::vector<Point> loop, double angle, Point by) {
  for (Point& p : loop)
    p = by + Point{std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y};
  return loop;
}

}  // namespace

TEST(Polygon, chains_that_cross_themselves_are_found_however_they_are_turned) {
  const std::vector<std::vector<Point>> crossed = {
      {{1, 0}, {2, 1}, {2, 0}, {1, 1.5}},                                  // in the middle of two edges
      {{0, 0}, {1, 1}, {2, 2}, {2, 0}, {1, 1}, {0, 2}},                    // a figure of eight through a corner
      {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}},    // twice around
      {{0, 0}, {4, 0}, {4, 2}, {1, 2}, {1, -1}, {3, -1}, {3, 4}, {0, 4}},  // over itself
  };
  for (std::size_t i = 0; i < crossed.size(); ++i)
    for (const double angle : {0.0, 0.3, 1.0, 2.5})
      for (const Point by : {Point{0, 0}, Point{1e5, -3e4}})
        EXPECT_NE(crossing_words({turned(crossed[i], angle, by)}), "") << i << " turned by " << angle;
}

TEST(Polygon, chains_that_touch_themselves_or_are_rounded_do_not_cross) {
  EXPECT_EQ(crossing_words({kEll}), "");
  EXPECT_EQ(crossing_words({{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 0}, {1, 4}, {0, 4}}}), "") << "a corner on an edge";
  for (const double angle : {0.0, 0.3, 1.0, 2.5})
    EXPECT_EQ(crossing_words({turned({{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}, angle, {7, 3})}), "")
        << "two triangles that meet in a corner, turned by " << angle;
  EXPECT_EQ(crossing_words({{{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}}), "") << "it turns back at the corner";
  EXPECT_EQ(crossing_words({{{0, 0}, {4, 0}, {4, 4}, {1, 3}, {1, 1}, {3, 2}, {1, 3}, {4, 4}, {0, 4}}}), "")
      << "a hole on a line of no width";
  EXPECT_EQ(crossing_words({{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, -1e-6}, {1, 4}, {0, 4}}}), "") << "round-off";
}

TEST(Polygon, edges_of_two_chains_that_cross_are_found) {
  const std::vector<Point> square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_EQ(crossing_words({square, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}}), "");
  EXPECT_EQ(crossing_words({square, {{1, 1}, {1, 2}, {5, 2}, {2, 1}}}), "0:1 1:1");
  EXPECT_EQ(crossing_words({square, {{1, 0}, {1, 2}, {2, 2}, {2, 0}}}), "") << "along an edge of the outer chain";
}

TEST(Polygon, an_inner_point_avoids_the_holes) {
  const std::vector<std::vector<Point>> ring{{{0, 0}, {3, 0}, {3, 3}, {0, 3}},
                                             {{1, 0.5}, {1, 2.5}, {2, 2.5}, {2, 0.5}}};
  const auto inside = point_inside(ring);
  ASSERT_TRUE(inside);
  EXPECT_EQ(side(ring[0], *inside), Side::inside);
  EXPECT_EQ(side(ring[1], *inside), Side::outside);
  EXPECT_FALSE(point_inside({}));
  EXPECT_FALSE(point_inside(std::vector<std::vector<Point>>{{{0, 0}, {1, 0}, {2, 0}}})) << "no area";
}

}  // namespace keyblock::polygon_test
