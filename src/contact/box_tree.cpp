// The only file that sees Boost's trees.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/box_tree.hpp"

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>

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

std::vector<std::pair<int, int>> touching_by_tree(const std::vector<Box>& boxes, double distance) {
  std::vector<Entry> entries;
  for (const Box& box : boxes) entries.emplace_back(grown(box, 0), static_cast<int>(entries.size()));
  const index::rtree<Entry, index::rstar<kEntriesOfNode>> tree(entries);
  std::vector<std::pair<int, int>> pairs;
  std::vector<Entry> met;
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
    met.clear();
    tree.query(index::intersects(grown(boxes[static_cast<std::size_t>(i)], distance)), std::back_inserter(met));
    for (const auto& [box, j] : met)
      if (j > i) pairs.emplace_back(i, j);
  }
  return pairs;
}

}  // namespace keyblock
