// Fills a uniform grid with segments; see segment_grid.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/lines/segment_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keyblock {
namespace {

/// Cell size of a quarter of the mean length: smaller cells add entries but save few tests (measured on two joint sets
/// and on random lines).
constexpr double kCellsPerMeanLength = 4;
/// Limit on cells per segment: pieces of an arrangement fill the plane, and more cells only need memory.
constexpr double kCellsPerSegment = 2;

}  // namespace

SegmentGrid::SegmentGrid(std::span<const Segment> segments, double margin) : margin_(margin) {
  Point high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};
  low_ = {std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  double total = 0;
  for (const Segment& s : segments) {
    low_ = {std::min({low_.x, s.start.x, s.end.x}), std::min({low_.y, s.start.y, s.end.y})};
    high = {std::max({high.x, s.start.x, s.end.x}), std::max({high.y, s.start.y, s.end.y})};
    total += distance(s.start, s.end);
  }
  if (segments.empty()) low_ = high = {};
  const double count = std::max<double>(1, static_cast<double>(segments.size()));
  const Point size{high.x - low_.x + 2 * margin, high.y - low_.y + 2 * margin};
  const double cells = kCellsPerSegment * count + 16;
  cell_ = std::max({total / count / kCellsPerMeanLength, std::sqrt(size.x * size.y / cells), 4 * margin,
                    std::max(size.x, size.y) / cells, std::numeric_limits<double>::min()});
  low_ = low_ - Point{margin, margin};
  columns_ = static_cast<int>(size.x / cell_) + 1;
  rows_ = static_cast<int>(size.y / cell_) + 1;

  start_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
  for (const Segment& s : segments) visit_cells(s, [&](std::size_t cell) { ++start_[cell + 1]; });
  for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
  entries_.resize(start_.back());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    visit_cells(segments[i], [&](std::size_t cell) { entries_[next[cell]++] = static_cast<int>(i); });
  }
  seen_.assign(segments.size(), 0);
}

int SegmentGrid::column(double x) const {
  return std::clamp(static_cast<int>(std::clamp((x - low_.x) / cell_, -1.0, 1e9)), 0, columns_ - 1);
}

int SegmentGrid::row(double y) const {
  return std::clamp(static_cast<int>(std::clamp((y - low_.y) / cell_, -1.0, 1e9)), 0, rows_ - 1);
}

template <class Visit>
void SegmentGrid::visit_cells(const Segment& s, Visit visit) const {
  // A thousandth of a cell covers the rounding of the clipped heights below.
  const double pad = margin_ + 1e-3 * cell_;
  const Point low{std::min(s.start.x, s.end.x), std::min(s.start.y, s.end.y)};
  const Point high{std::max(s.start.x, s.end.x), std::max(s.start.y, s.end.y)};
  const Point along = s.end - s.start;
  const int first_column = column(low.x - pad);
  const int last_column = column(high.x + pad);
  const double slope = along.x != 0 ? along.y / along.x : 0;
  for (int c = first_column; c <= last_column; ++c) {
    double bottom = low.y;
    double top = high.y;
    if (along.x != 0 && first_column != last_column) {
      const double left = low_.x + c * cell_ - pad;
      const double y0 = s.start.y + slope * (left - s.start.x);
      const double y1 = s.start.y + slope * (left + cell_ + 2 * pad - s.start.x);
      bottom = std::max(bottom, std::min(y0, y1));
      top = std::min(top, std::max(y0, y1));
    }
    const int last_row = row(top + pad);
    for (int r = row(bottom - pad); r <= last_row; ++r) visit(static_cast<std::size_t>(r) * columns_ + c);
  }
}

const std::vector<int>& SegmentGrid::near(const Segment& segment, int limit) {
  ++call_;
  found_.clear();
  visit_cells(segment, [&](std::size_t cell) {
    for (std::size_t k = start_[cell]; k < start_[cell + 1] && entries_[k] < limit; ++k) {
      const int i = entries_[k];
      if (seen_[i] == call_) continue;
      seen_[i] = call_;
      found_.push_back(i);
    }
  });
  std::sort(found_.begin(), found_.end());
  return found_;
}

}  // namespace keyblock
