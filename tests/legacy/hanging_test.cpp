// The unknowns that an element takes from its nodes are those of the affine field through them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/hanging.hpp"

#include <gtest/gtest.h>

namespace keyblock::hanging_test {

TEST(Hanging, an_affine_field_comes_back_wherever_the_centroid_lies) {
  const std::array<Point, 3> corners{Point{1, 2}, Point{4, 1.5}, Point{2, 5}};
  const double translation_x = 0.3, translation_y = -0.2, rotation = 0.04, ex = 0.01, ey = -0.03, gxy = 0.05;
  for (const Point centroid : {Point{2, 2.5}, Point{-7, 9}}) {
    const auto field = [&](Point p) {
      const Point arm = p - centroid;
      return Eigen::Vector2d(translation_x - rotation * arm.y + ex * arm.x + gxy / 2 * arm.y,
                             translation_y + rotation * arm.x + ey * arm.y + gxy / 2 * arm.x);
    };
    Eigen::Matrix<double, 6, 1> nodes;
    nodes << field(corners[0]), field(corners[1]), field(corners[2]);
    const Eigen::Matrix<double, 6, 1> unknowns = affine_from_corners(corners, centroid) * nodes;
    Eigen::Matrix<double, 6, 1> expected;
    expected << translation_x, translation_y, rotation, ex, ey, gxy;
    EXPECT_LT((unknowns - expected).norm(), 1e-14);
  }
}

}  // namespace keyblock::hanging_test
