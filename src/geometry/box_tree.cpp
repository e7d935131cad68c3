// Finds pairs by Boost's trees, which no other file includes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/box_tree.hpp"

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>

namespace keyblock {
namespace {

namespace index = boost::geometry::index;
using Corner = boost::geometry::model::d2::point_xy<double>;
using TreeBox = boost::geometry::model::box<Corner>;
using Entry = std::pair<TreeBox, int>;

constexpr std::size_t kEntriesOfNode = 16;

TreeBox grown(const Box& box, double by) {
  return {{box.low.x - by, box.low.y - by}, {box.high.x + by, box.high.y + by}};
}

}  // namespace

void visit_touching(const std::vector<Box>& boxes, double distance, const std::function<bool(int, int)>& visit) {
  std::vector<Entry> entries;
  for (const Box& box : boxes) entries.emplace_back(grown(box, 0), static_cast<int>(entries.size()));
  const index::rtree<Entry, index::rstar<kEntriesOfNode>> tree(entries);
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
    const auto reach = index::intersects(grown(boxes[static_cast<std::size_t>(i)], distance));
    for (auto met = tree.qbegin(reach); met != tree.qend(); ++met)
      if (met->second > i && !visit(i, met->second)) return;
  }
}

std::vector<std::pair<int, int>> touching_by_tree(const std::vector<Box>& boxes, double distance) {
  std::vector<std::pair<int, int>> pairs;
  visit_touching(boxes, distance, [&](int i, int j) {
    pairs.emplace_back(i, j);
    return true;
  });
  return pairs;
}

}  // namespace keyblock
