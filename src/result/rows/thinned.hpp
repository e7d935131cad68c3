// Keeps a bounded number of the rows that a long run tells, the same ones whether it was interrupted or not.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/archive.hpp"

namespace keyblock {

/// Rows of steps to be kept of one table, beside the extremes and the last.
constexpr int kMostRows = 5'000;

/// The stride under which a run of so many steps leaves at most kMostRows: 1, where it has no more.
constexpr int stride_of(int steps) {
  return std::max(1, (steps + kMostRows - 1) / kMostRows);
}

/// Rows with a number `step`, in rising order: every `stride`-th, the last, and the first row of the greatest value of
/// each of `Extremes`: functions of a row.
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

  /// The last row added; none before the first. Valid until the next one.
  const Row* last() const { return last_.empty() ? nullptr : &last_.back(); }

  /// The rows kept, each once, in the order of steps. A new list: references into it end with it.
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
  std::vector<Row> extremes_;  ///< none, where the stride is 1
  std::vector<Row> last_;      ///< one, once there is any
};

}  // namespace keyblock
