// Rows of a long run that are kept; an interruption changes none.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/rows/thinned.hpp"

#include <gtest/gtest.h>

#include <array>

#include "run/checkpoint.hpp"

namespace keyblock::thinned_test {
namespace {

struct Row {
  int step = 0;
  double height = 0;
};

struct Highest {
  static constexpr std::array<double (*)(const Row&), 2> values{[](const Row& r) { return r.height; },
                                                                [](const Row& r) { return -r.height; }};
};

using Rows = Thinned<Row, Highest>;

void describe_row(Archive& archive, Row& row) {
  archive.value("step", row.step);
  archive.value("height", row.height);
}

std::vector<int> steps_of(const Rows& rows) {
  std::vector<int> steps;
  for (const Row& row : rows.rows()) steps.push_back(row.step);
  return steps;
}

// Heights 1, except a peak at 7 and a hollow at 13; the first of equal ones is the extreme.
Row row_of(int step) {
  return {step, step == 7 ? 2.0 : step == 13 ? 0.5 : 1.0};
}

}  // namespace

TEST(Thinned, the_last_row_is_one_that_is_kept) {
  Rows rows(3);
  EXPECT_EQ(rows.last(), nullptr);
  for (int step = 0; step < 8; ++step) rows.add(row_of(step));
  ASSERT_NE(rows.last(), nullptr);
  EXPECT_EQ(rows.last(), rows.last()) << "not of a list made anew";
  EXPECT_EQ(rows.last()->step, 7);
  EXPECT_EQ(rows.last()->height, 2);
}

TEST(Thinned, the_stride_leaves_at_most_the_promised_number) {
  EXPECT_EQ(stride_of(1), 1);
  EXPECT_EQ(stride_of(kMostRows), 1);
  EXPECT_EQ(stride_of(kMostRows + 1), 2);
  EXPECT_EQ(stride_of(10 * kMostRows), 10);
  EXPECT_EQ(stride_of(2'000'000'000), 2'000'000'000 / kMostRows);
}

TEST(Thinned, short_runs_keep_every_row) {
  Rows rows(1);
  for (int step = 1; step <= 5; ++step) rows.add(row_of(step));
  EXPECT_EQ(steps_of(rows), (std::vector<int>{1, 2, 3, 4, 5}));
}

TEST(Thinned, long_runs_keep_every_so_many_the_extremes_and_the_last) {
  Rows rows(5);
  for (int step = 0; step <= 17; ++step) rows.add(row_of(step));
  EXPECT_EQ(steps_of(rows), (std::vector<int>{0, 5, 7, 10, 13, 15, 17}));
}

TEST(Thinned, a_table_left_anywhere_and_restored_goes_on_to_the_same_rows) {
  for (int left = 0; left <= 17; ++left) {
    Rows rows(5);
    for (int step = 0; step <= left; ++step) rows.add(row_of(step));
    Archive saved;
    rows.describe(saved, [&](Row& row) { describe_row(saved, row); });
    Archive again = archive_of_checkpoint("a.h5", checkpoint_bytes(saved));
    Rows restored(5);
    restored.describe(again, [&](Row& row) { describe_row(again, row); });
    for (int step = left + 1; step <= 17; ++step) restored.add(row_of(step));
    EXPECT_EQ(steps_of(restored), (std::vector<int>{0, 5, 7, 10, 13, 15, 17})) << left;
  }
}

}  // namespace keyblock::thinned_test
