// What holds and what does not: no value, not a number, another quantity, a run that ended early.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/compare.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::study {
namespace {

namespace fs = std::filesystem;

/// Free fall (400 steps of 5 ms) with the given rows for expected values.
ComparedCase compared(const std::string& rows) {
  const fs::path folder = fs::path(testing::fresh_folder("compare")) / "released";
  fs::copy(KEYBLOCK_SOURCE_DIR "/legacy_cases/free_fall/released", folder);
  testing::write_text(folder / "expected.csv", "quantity,block,time,value,tolerance,tolerance_reason,source\n" + rows);
  return compare_case(find_cases({folder.string()}).front(), "legacy");
}

ComparedValue value(std::optional<double> computed, double tolerance) {
  ComparedValue v;
  v.expected = 1;
  v.computed = computed;
  v.tolerance = tolerance;
  return v;
}

}  // namespace

TEST(Compare, a_value_holds_within_its_tolerance_and_only_if_there_is_one) {
  EXPECT_TRUE(value(1.25, 0.25).holds());
  EXPECT_TRUE(value(0.75, 0.25).holds());
  EXPECT_FALSE(value(1.26, 0.25).holds());
  EXPECT_FALSE(value(0.74, 0.25).holds());
  EXPECT_FALSE(value(std::nullopt, 10).holds());
  EXPECT_FALSE(value(std::nan(""), 10).holds());
  EXPECT_FALSE(value(1, std::nan("")).holds());
}

TEST(Compare, a_case_holds_if_the_run_finished_and_every_value_holds) {
  ComparedCase good;
  good.values = {value(1, 0.1), value(1, 0.1)};
  EXPECT_TRUE(good.holds());
  ComparedCase stopped = good;
  stopped.outcome.end = RunEnd::failed;
  EXPECT_FALSE(stopped.holds());
  ComparedCase off = good;
  off.values[1].computed = 2;
  EXPECT_FALSE(off.holds());
}

// s = g t²/2 = 1.22625 at 0.5 s, 4.905 at 1 s.
TEST(Compare, values_are_picked_at_their_block_and_time) {
  const ComparedCase fall =
      compared("dy,2,0.5,-1.22625,1e-9,r,s\ndy,2,1,-4.905,1e-9,r,s\ndy,1,1,0,1e-3,r,s\nblock_count,,1,2,0,r,s\n");
  EXPECT_TRUE(fall.holds());
  EXPECT_EQ(fall.times.size(), 401U);
  EXPECT_NEAR(fall.displacements[100], 1.22625, 1e-9);
  EXPECT_EQ(fall.start.step, 0);
  EXPECT_EQ(fall.end.step, 400);
}

TEST(Compare, a_time_that_the_run_does_not_reach_does_not_hold) {
  const ComparedCase fall = compared("dy,2,5,0,1e9,r,s\n");
  EXPECT_FALSE(fall.values[0].computed);
  EXPECT_FALSE(fall.holds());
}

TEST(Compare, an_unknown_quantity_or_block_is_refused) {
  EXPECT_THROW(compared("colour,2,1,0,1,r,s\n"), InputError);
  EXPECT_THROW(compared("block_count,2,1,0,1,r,s\n"), InputError) << "a quantity of the scene, not of a block";
  EXPECT_THROW(compared("dy,3,1,0,1,r,s\n"), InputError);
  EXPECT_THROW(compared("dy,0,1,0,1,r,s\n"), InputError);
  EXPECT_THROW(compared("dy,2,1,nan,1,r,s\n"), InputError);
}

}  // namespace keyblock::study
