// Histories and warnings of a run in memory are those of a run with results in a folder.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <keyblock/record.hpp>
#include <stdexcept>
#include <utility>

#include "tests/library/example_cases.hpp"

namespace keyblock::api_test {
namespace {

namespace fs = std::filesystem;

using Told = std::vector<std::pair<std::string, std::string>>;

/// Returns code and sentence of each warning, sorted.
Told told(const std::vector<kb::Warning>& warnings) {
  Told all;
  for (const kb::Warning& warning : warnings) all.emplace_back(warning.code, warning.sentence);
  std::ranges::sort(all);
  return all;
}

bool has(const Told& all, std::string_view code, std::string_view part) {
  return std::ranges::any_of(
      all, [&](const auto& one) { return one.first == code && one.second.find(part) != std::string::npos; });
}

struct Folder {
  fs::path path = fs::path(::testing::TempDir()) / (std::string("keyblock_histories_") +
                                                    ::testing::UnitTest::GetInstance()->current_test_info()->name());
  Folder() { fs::remove_all(path); }
  ~Folder() { fs::remove_all(path); }
};

}  // namespace

TEST(Histories, a_run_in_memory_warns_as_the_program_does) {
  const Folder folder;
  const std::vector<std::string> histories{"ends=contact:2,7", "self=contact:1,1"};
  const kb::Case bricks = wall(6, 1);
  kb::Run run(kb::Plan(bricks, {"", {}, histories}));
  const Told in_memory = told(run.go_on().warnings);
  const kb::Outcome recorded = kb::record(bricks, folder.path.string(), {.pictures = false, .histories = histories});
  EXPECT_EQ(in_memory, told(recorded.warnings));
  EXPECT_TRUE(has(in_memory, "history_of_distant_blocks", "blocks 2 and 7 are 4 apart before any load"));
  EXPECT_TRUE(has(in_memory, "history_of_nothing", "\"contact ends\": no contact of blocks 2 and 7 is closed"));
  EXPECT_TRUE(has(in_memory, "history_of_nothing", "\"contact self\": no contact of blocks 1 and 1 is closed"));
}

// Of 20,000 steps every fourth has a row. The condition ends the run between two of them.
TEST(Histories, a_run_that_ends_early_has_a_row_of_its_last_step) {
  const Folder folder;
  constexpr int kLast = 10;
  const kb::Choices choices{"", {{"steps", "20000"}}, {}};
  kb::Run run = kb::recorded(slide(), folder.path.string(), {.pictures = false, .histories = {"block:2"}}, choices);
  run.go_on([](const kb::Run& now) { return now.last().number == kLast; });
  const kb::Column<double> kept = run.history("2", "displacement_x");
  ASSERT_EQ(kept.rows(), 4U) << "steps 0, 4, 8 and 10";
  EXPECT_EQ(kept(3, 0), run.last().time);
  EXPECT_GT(std::abs(kept(3, 1)), std::abs(kept(2, 1)));
  std::ifstream table(folder.path / "histories.csv");
  std::string line, last;
  while (std::getline(table, line)) last = line;
  EXPECT_EQ(last.substr(0, last.find(',')), std::to_string(kLast)) << last;
}

TEST(Histories, a_resumed_run_keeps_the_rows_before_its_checkpoint) {
  const Folder folder;
  const auto past = [](int step) { return [step](const kb::Run& now) { return now.last().number == step; }; };
  const kb::Recording how{.pictures = false, .histories = {"block:2"}};
  kb::Run first = kb::recorded(slide(), folder.path.string(), how);
  first.go_on(past(8));
  const kb::Column<double> before = first.history("2", "displacement_x");
  EXPECT_EQ(before.rows(), 9U);
  kb::Run second = kb::resumed(folder.path.string());
  for (int step = 9; step <= 12; ++step) ASSERT_TRUE(second.advance());
  EXPECT_EQ(second.histories(), std::vector<std::string>{"2"});
  const kb::Column<double> after = second.history("2", "displacement_x");
  ASSERT_EQ(after.rows(), 13U);
  for (std::size_t row = 0; row < before.rows(); ++row) EXPECT_EQ(after(row, 1), before(row, 1)) << row;
  EXPECT_EQ(second.history("ledger", "kinetic").rows(), 13U);
  kb::Run whole(kb::Plan(slide(), {"", {}, {"block:2"}}));
  whole.go_on(past(12));
  const kb::Column<double> expected = whole.history("2", "displacement_x");
  for (std::size_t row = 0; row < after.rows(); ++row) EXPECT_EQ(after(row, 1), expected(row, 1)) << row;
}

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
  EXPECT_EQ(code_of([&] { run.quantities("bottom"); }), kb::ErrorCode::choice);
  EXPECT_EQ(code_of([&] { run.history("bottom", "rotation"); }), kb::ErrorCode::choice);
  EXPECT_EQ(code_of([&] { run.history("top", "colour"); }), kb::ErrorCode::choice);
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

TEST(Histories, what_a_callback_throws_keeps_its_type) {
  const Folder folder;
  const auto thrown_at = [](int number, const auto& error) {
    return [=](const kb::Step& step) {
      if (step.number == number) throw error;
    };
  };
  const std::string path = folder.path.string();
  const std::invalid_argument invalid("from the caller");
  EXPECT_THROW(kb::record(slide(), path, {.pictures = false, .on_step = thrown_at(2, invalid)}), std::invalid_argument);
  EXPECT_THROW(kb::resume(path, thrown_at(3, 7)), int);
  EXPECT_EQ(code_of([&] { kb::resume(path, thrown_at(4, kb::Error("by the caller", kb::ErrorCode::stopped))); }),
            kb::ErrorCode::stopped);
  kb::Run run = kb::recorded(slide(), path, {.overwrite = true, .pictures = false, .on_step = thrown_at(2, invalid)});
  EXPECT_TRUE(run.advance());
  EXPECT_THROW(run.advance(), std::invalid_argument);
}

TEST(Histories, tables_of_a_run_that_goes_on_after_an_exception_are_whole) {
  const Folder folder;
  const auto throws = [](const kb::Step& step) {
    if (step.number == 2) throw std::invalid_argument("from the caller");
  };
  kb::Run run = kb::recorded(slide(), folder.path.string(), {.pictures = false, .on_step = throws});
  EXPECT_TRUE(run.advance());
  EXPECT_THROW(run.advance(), std::invalid_argument);
  run.go_on();
  std::ifstream ledger(folder.path / "ledger.csv");
  const auto lines = std::count(std::istreambuf_iterator<char>(ledger), {}, '\n');
  EXPECT_EQ(lines, run.outcome().steps + 2);  // the title and the start
}

}  // namespace keyblock::api_test
