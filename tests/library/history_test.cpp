// Histories of runs of the public library, in memory and in a folder, and runs that end early.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <keyblock/record.hpp>
#include <utility>

#include "tests/library/example_cases.hpp"

namespace keyblock::api_test {
namespace {

namespace fs = std::filesystem;

struct Folder {
  fs::path path = fs::path(::testing::TempDir()) / (std::string("keyblock_histories_") +
                                                    ::testing::UnitTest::GetInstance()->current_test_info()->name());
  Folder() { fs::remove_all(path); }
  ~Folder() { fs::remove_all(path); }
};

}  // namespace

TEST(Histories, names_quantities_and_units_are_listed) {
  kb::Run run(kb::Plan(wall(1, 1), {"", {}, {"top=block:2", "joint=contact:1,2"}}));
  EXPECT_EQ(run.histories(), (std::vector<std::string>{"top", "joint"}));
  const auto has_unit = [&](std::string_view history, const std::string& quantity, const std::string& unit) {
    return std::ranges::count(run.quantities(history), std::pair(quantity, unit)) == 1;
  };
  EXPECT_TRUE(has_unit("top", "displacement_x", "m"));
  EXPECT_TRUE(has_unit("top", "rotation", "rad"));
  EXPECT_TRUE(has_unit("joint", "closed_contacts", "1"));
  EXPECT_TRUE(has_unit("ledger", "kinetic", "N·m/m"));
  EXPECT_THROW(run.quantities("bottom"), kb::SettingError);
  EXPECT_THROW(run.history("bottom", "rotation"), kb::SettingError);
  EXPECT_THROW(run.history("top", "colour"), kb::SettingError);
}

TEST(Histories, a_run_in_memory_is_not_ended_early) {
  kb::Run run((kb::Plan(slide())));
  EXPECT_TRUE(run.advance());
  run.end_early("enough");
  EXPECT_TRUE(run.advance());
  EXPECT_EQ(run.outcome().end, kb::End::running);
}

TEST(Histories, a_recorded_run_ended_early_says_why_and_makes_no_step_more) {
  const Folder folder;
  kb::Run run = kb::recorded(slide(), folder.path.string(), {.pictures = false});
  EXPECT_TRUE(run.advance());
  run.end_early("enough is seen");
  EXPECT_FALSE(run.advance());
  EXPECT_EQ(run.outcome().end, kb::End::stopped);
  EXPECT_EQ(run.outcome().reason, "enough is seen");
  EXPECT_EQ(run.outcome().steps, 1);
}

}  // namespace keyblock::api_test
