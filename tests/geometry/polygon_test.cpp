// Area and centroid do not suffer from a far origin, containment is decided at vertices and edges too.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polygon.hpp"

#include <gtest/gtest.h>

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
