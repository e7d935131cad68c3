// Finds close elements with a uniform grid over their bounding boxes, in linear time if sizes are alike; otherwise with
// a tree.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/find/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/box_tree.hpp"

namespace keyblock {

Box box_of(const Model& model, const State& state, ElementIndex element) {
  Box box;
  for (VertexIndex v : model.elements[element].vertices()) box.add(state.vertices[v]);
  return box;
}

bool touch(const Box& a, const Box& b, double distance) {
  return a.low.x - distance <= b.high.x && b.low.x <= a.high.x + distance && a.low.y - distance <= b.high.y &&
         b.low.y <= a.high.y + distance;
}

namespace {

// Up to this number of elements all pairs are tested: a grid would take longer.
constexpr std::size_t kFew = 8;

// A box that covers more cells than this is tested against all others: one huge element must not fill the grid. If more
// than kMostLarge boxes are that large, a tree replaces the grid.
constexpr double kMostCells = 64;
constexpr std::ptrdiff_t kMostLarge = 32;

class Grid {
 public:
  Grid(const std::vector<Box>& boxes, double distance) : distance_(distance) {
    origin_ = boxes.front().low;
    Point far = boxes.front().high;
    std::vector<double> sizes;
    for (const Box& box : boxes) {
      origin_ = {std::min(origin_.x, box.low.x), std::min(origin_.y, box.low.y)};
      far = {std::max(far.x, box.high.x), std::max(far.y, box.high.y)};
      sizes.push_back(std::max(box.high.x - box.low.x, box.high.y - box.low.y));
    }
    std::ranges::nth_element(sizes, sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2));
    // Cells have the size of a typical element, but the grid must not outgrow the scene.
    const Point extent = far - origin_;
    const double smallest =
        std::sqrt((extent.x + distance) * (extent.y + distance) / (4.0 * static_cast<double>(boxes.size())));
    // An almost one-dimensional scene has cells along its length only, in limited number.
    const double along = std::max(extent.x, extent.y) / (4.0 * static_cast<double>(boxes.size()));
    cell_ = std::max({sizes[sizes.size() / 2] + distance, smallest, along, std::numeric_limits<double>::min()});
    columns_ = static_cast<int>(extent.x / cell_) + 1;
    rows_ = static_cast<int>(extent.y / cell_) + 1;
    last_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1);
  }

  struct Range {
    int left, right, bottom, top;
    double cells() const { return (right - left + 1.0) * (top - bottom + 1.0); }
  };

  Range range_of(const Box& box, double margin) const {
    const auto index = [this](double x, int count) {
      return std::clamp(static_cast<int>(std::floor(x / cell_)), 0, count - 1);
    };
    return {index(box.low.x - margin - origin_.x, columns_), index(box.high.x + margin - origin_.x, columns_),
            index(box.low.y - margin - origin_.y, rows_), index(box.high.y + margin - origin_.y, rows_)};
  }

  void add(const Range& range, int box) {
    for (int row = range.bottom; row <= range.top; ++row)
      for (int column = range.left; column <= range.right; ++column) {
        int& last = last_[cell(column, row)];
        entries_.push_back({box, last});
        last = static_cast<int>(entries_.size()) - 1;
      }
  }

  /// Calls `seen(box)` for all boxes added in these cells, some more than once.
  template <class Seen>
  void visit(const Range& range, const Seen& seen) const {
    for (int row = range.bottom; row <= range.top; ++row)
      for (int column = range.left; column <= range.right; ++column)
        for (int i = last_[cell(column, row)]; i >= 0; i = entries_[static_cast<std::size_t>(i)].before)
          seen(entries_[static_cast<std::size_t>(i)].box);
  }

 private:
  std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  double distance_;
  Point origin_;
  double cell_ = 0;
  int columns_ = 0;
  int rows_ = 0;
  /// Box in a cell, and the last earlier entry of that cell; -1: no earlier one.
  struct Entry {
    int box;
    int before;
  };
  std::vector<Entry> entries_;
  std::vector<int> last_;  ///< per cell
};

}  // namespace

std::vector<ElementPair> close_pairs(const Model& model, const State& state, double distance) {
  std::vector<ElementIndex> all;
  for (ElementIndex e : indices(model.elements)) all.push_back(e);
  return close_pairs(model, state, all, distance);
}

std::vector<ElementPair> close_pairs(const Model& model, const State& state, const std::vector<ElementIndex>& among,
                                     double distance) {
  std::vector<Box> boxes;
  boxes.reserve(among.size());
  for (ElementIndex e : among) boxes.push_back(box_of(model, state, e));
  std::vector<ElementPair> pairs;
  if (boxes.size() <= kFew) {
    for (std::size_t b = 0; b < boxes.size(); ++b)
      for (std::size_t a = 0; a < b; ++a)
        if (touch(boxes[a], boxes[b], distance)) pairs.push_back({among[a], among[b]});
    std::ranges::sort(pairs);
    return pairs;
  }
  Grid grid(boxes, distance);
  const auto is_large = [&](const Box& box) { return grid.range_of(box, distance).cells() > kMostCells; };
  if (std::ranges::count_if(boxes, is_large) > kMostLarge) {
    for (const auto& [a, b] : touching_by_tree(boxes, distance))
      pairs.push_back({among[static_cast<std::size_t>(a)], among[static_cast<std::size_t>(b)]});
    std::ranges::sort(pairs);
    return pairs;
  }
  std::vector<int> large;
  std::vector<int> met;
  const auto test = [&](int a, int b) {
    if (touch(boxes[static_cast<std::size_t>(a)], boxes[static_cast<std::size_t>(b)], distance)) met.push_back(a);
  };
  // Elements enter in ascending order. Each is tested against those already in the grid, and later ones then find it.
  for (int b = 0; b < static_cast<int>(boxes.size()); ++b) {
    met.clear();
    const Box& box = boxes[static_cast<std::size_t>(b)];
    const Grid::Range range = grid.range_of(box, distance);
    if (is_large(box)) {
      for (int a = 0; a < b; ++a) test(a, b);
      large.push_back(b);
    } else {
      for (int a : large) test(a, b);
      grid.visit(range, [&](int a) { test(a, b); });
      grid.add(grid.range_of(box, 0), b);
    }
    std::ranges::sort(met);
    met.erase(std::unique(met.begin(), met.end()), met.end());
    for (int a : met) pairs.push_back({among[static_cast<std::size_t>(a)], among[static_cast<std::size_t>(b)]});
  }
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace keyblock
