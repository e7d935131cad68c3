// Outlines enclose the areas of their shapes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/polygon.hpp"

namespace keyblock::outline_test {
namespace {

using std::numbers::pi;

// A polygon of n corners in a circle: its area over the circle's is sin(2π/n) / (2π/n).
const double kPolygonShare = std::sin(2 * pi / kChordsOfCircle) / (2 * pi / kChordsOfCircle);

struct Size {
  double width, height;
};

Size size_of(const Outline& outline) {
  const auto [left, right] = std::ranges::minmax(outline, {}, &Point::x);
  const auto [low, high] = std::ranges::minmax(outline, {}, &Point::y);
  return {right.x - left.x, high.y - low.y};
}

TunnelSection tunnel(TunnelShape shape, double width, double height) {
  return {shape, 3, -2, width, height, {}};
}

}  // namespace

TEST(Outline, rectangle_and_slope_enclose_their_areas) {
  EXPECT_EQ(area(outline_of(RectangleShape{1, 2, 3, 4})), 12);
  // Ground 20 deep over 10 + 10 + 30, and a face of 45°: the triangle 10 × 10 / 2 and 30 × 10 behind it.
  EXPECT_NEAR(area(outline_of(SlopeShape{0, 0, 10, 45, 0, 1, 10, 30, 20})), 50 * 20 + 50 + 300, 1e-9);
  // Upright face: no triangle.
  EXPECT_EQ(area(outline_of(SlopeShape{0, 0, 10, 90, 0, 1, 10, 30, 20})), 40 * 20 + 300);
}

TEST(Outline, benches_part_the_face_into_equal_lifts) {
  // Two lifts of 5 at 45° and a bench of 4 between: the triangles, the rock behind the lower one, the crest.
  const Outline slope = outline_of(SlopeShape{0, 0, 10, 45, 4, 2, 0, 6, 1});
  EXPECT_NEAR(area(slope), 20 * 1 + 2 * 12.5 + 9 * 5 + 6 * 10, 1e-9);
  EXPECT_EQ(slope.size(), 7u);
}

TEST(Outline, tunnels_have_the_width_height_and_area_of_their_shape) {
  const Outline circle = outline_of(tunnel(TunnelShape::circle, 4, 4));
  EXPECT_NEAR(area(circle), kPolygonShare * pi * 4, 1e-12);
  const Outline d = outline_of(tunnel(TunnelShape::d, 4, 5));
  EXPECT_NEAR(area(d), kPolygonShare * pi * 2 + 4 * 3, 1e-12);
  // Below the springing of a horseshoe of r = 2, 2 deep: each side x(y) = -r + √(4r² - y²).
  const Outline shoe = outline_of(tunnel(TunnelShape::horseshoe, 4, 4));
  const double below = 2 * (-2 * 2 + 0.5 * (2 * std::sqrt(12.0) + 16 * std::asin(0.5)));
  EXPECT_NEAR(area(shoe), pi * 2 + below, 0.01 * (pi * 2 + below));
  EXPECT_LT(area(shoe), pi * 2 + below) << "chords lie inside";
  for (const Outline& outline : {circle, shoe}) {
    EXPECT_NEAR(size_of(outline).width, 4, 1e-12);
    EXPECT_NEAR(size_of(outline).height, 4, 1e-12);
  }
  EXPECT_NEAR(size_of(d).height, 5, 1e-12);
  EXPECT_NEAR(std::ranges::max(d, {}, &Point::y).y, -2 + 2.5, 1e-12);
}

TEST(Outline, tunnels_that_cannot_be_are_refused) {
  EXPECT_THROW(outline_of(tunnel(TunnelShape::d, 4, 1.9)), InputError);
  EXPECT_THROW(outline_of(tunnel(TunnelShape::horseshoe, 4, 1.9)), InputError);
  EXPECT_THROW(outline_of(tunnel(TunnelShape::horseshoe, 4, 5.5)), InputError);
}

}  // namespace keyblock::outline_test
