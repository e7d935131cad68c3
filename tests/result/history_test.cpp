// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/history.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace keyblock {
namespace {

std::vector<int> steps_kept(int stride, int steps) {
  History history;
  history.stride = stride;
  for (int step = 0; step <= steps; ++step) {
    HistoryRow row;
    row.step = step;
    history.add(row);
  }
  std::vector<int> kept;
  for (const HistoryRow& row : history.rows) kept.push_back(row.step);
  return kept;
}

}  // namespace

TEST(History, every_row_is_kept_with_a_stride_of_one) {
  EXPECT_EQ(steps_kept(1, 4), (std::vector{0, 1, 2, 3, 4}));
}

TEST(History, rows_between_those_of_the_stride_give_way_to_the_last) {
  EXPECT_EQ(steps_kept(3, 10), (std::vector{0, 3, 6, 9, 10}));
  EXPECT_EQ(steps_kept(3, 9), (std::vector{0, 3, 6, 9}));
  EXPECT_EQ(steps_kept(100, 250), (std::vector{0, 100, 200, 250}));
}

}  // namespace keyblock
