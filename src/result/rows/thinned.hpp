// Keeps a bounded number of rows of a long run, the same for interrupted and uninterrupted runs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/archive.hpp"

namespace keyblock {

/// Rows of steps kept in one table, besides the extremes and the last.
constexpr int kMostRows = 5'000;

/// Returns the stride with which a run of so many steps keeps at most kMostRows: 1 if it has no more.
constexpr int stride_of(int steps) {
  return std::max(1, (steps + kMostRows - 1) / kMostRows);
}

/// Rows with a number `step`, ascending. It keeps every `stride`-th row, the last, and the first row with the greatest
/// value of each of `Extremes`, which are functions of a row.
template <class Row, class Extremes>
class Thinned {
 public:
  explicit Thinned(int stride = 1) : stride_(stride) {}

  int stride() const { return stride_; }

  void add(const Row& row) {
    if (row.step % stride_ == 0) even_.push_back(row);
    last_.assign(1, row);
    if (stride_ == 1) return;
    if (extremes_.empty()) return extremes_.assign(Extremes::values.size(), row);
    for (std::size_t i = 0; i < extremes_.size(); ++i)
      if (Extremes::values[i](row) > Extremes::values[i](extremes_[i])) extremes_[i] = row;
  }

  /// Returns the last row added, or null before the first. Valid until the next one.
  const Row* last() const { return last_.empty() ? nullptr : &last_.back(); }

  /// Returns the kept rows, each once, in the order of steps. The list is new: references into it end with it.
  std::vector<Row> rows() const {
    std::vector<Row> rows = even_;
    rows.insert(rows.end(), extremes_.begin(), extremes_.end());
    rows.insert(rows.end(), last_.begin(), last_.end());
    std::ranges::stable_sort(rows, {}, &Row::step);
    const auto repeated = std::ranges::unique(rows, {}, &Row::step);
    rows.erase(repeated.begin(), repeated.end());
    return rows;
  }

  template <class DescribeRow>
  void describe(Archive& archive, const DescribeRow& describe_row) {
    archive.list("even", even_, describe_row);
    archive.list("extremes", extremes_, describe_row);
    archive.list("last", last_, describe_row);
    if (archive.is_restoring() && !extremes_.empty() && extremes_.size() != Extremes::values.size())
      archive.refuse("extremes", "expected one row for each, found another number");
  }

 private:
  int stride_;
  std::vector<Row> even_;
  std::vector<Row> extremes_;  ///< empty if the stride is 1
  std::vector<Row> last_;      ///< one row, after the first
};

}  // namespace keyblock
