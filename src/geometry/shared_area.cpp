// Finds pairs by their boxes, then computes their common area.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/shared_area.hpp"

#include <algorithm>

#include "geometry/box_tree.hpp"
#include "geometry/polygon.hpp"

namespace keyblock {
namespace {

// Products of corners after which the rest is not tested: walls and slopes need some 30 per corner.
constexpr double kWorkOfCorner = 300;
constexpr double kWorkAtLeast = 1e6;

double area_of(const Loops& loops) {
  double sum = 0;
  for (const std::vector<Point>& loop : loops) sum += area(loop);
  return sum;
}

double corners_of(const Loops& loops) {
  std::size_t count = 0;
  for (const std::vector<Point>& loop : loops) count += loop.size();
  return static_cast<double>(count);
}

}  // namespace

SharedArea shared_area(const std::vector<Loops>& bodies, double least) {
  std::vector<Box> boxes;
  double left = kWorkAtLeast;
  for (const Loops& body : bodies) {
    for (Box& box = boxes.emplace_back(); const Point p : body.front()) box.add(p);
    left += kWorkOfCorner * corners_of(body);
  }
  SharedArea found;
  visit_touching(boxes, 0, [&](int i, int j) {
    const Loops& a = bodies[static_cast<std::size_t>(i)];
    const Loops& b = bodies[static_cast<std::size_t>(j)];
    left -= corners_of(a) * corners_of(b);
    found.is_complete = left >= 0;
    if (!found.is_complete) return false;
    const double smaller = std::min(area_of(a), area_of(b));
    const double share = common_area(a, b) / smaller;
    if (!(smaller > 0) || !(share > least)) return true;
    if (found.pairs == 0 || (i == found.first && j < found.second)) found = {i, j, share, found.pairs, true};
    ++found.pairs;
    return found.pairs < kMostSharedPairs;
  });
  return found;
}

}  // namespace keyblock
