// The side required at a place, found among the nearest of many points, is that of a search of all.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/mesh/mesh_size.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace keyblock::mesh_size_test {
namespace {

TEST(MeshSize, is_the_least_of_all_cones) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(-1, 1), digits(-6, 0);
  std::vector<RefinedPoint> points;
  for (int i = 0; i < 2000; ++i) points.push_back({{place(random), place(random)}, std::pow(10, digits(random))});
  for (int i = 0; i < 10; ++i) points.push_back(points[static_cast<std::size_t>(i)]);
  for (const double growth : {0.3, 0.5}) {
    const MeshSize size(0.4, points, growth);
    for (int i = 0; i < 2000; ++i) {
      const Point p{2 * place(random), 2 * place(random)};
      double least = 0.4;
      for (const RefinedPoint& point : points) least = std::min(least, point.side + growth * distance(point.at, p));
      EXPECT_EQ(size.at(p), least);
    }
  }
}

TEST(MeshSize, is_the_side_where_there_are_no_points) {
  const MeshSize size(0.4, {}, 0.3);
  EXPECT_EQ(size.at({5, -7}), 0.4);
  EXPECT_EQ(size.least(), 0.4);
}

}  // namespace
}  // namespace keyblock::mesh_size_test
