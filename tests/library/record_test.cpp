// The library records the same files as the program.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <keyblock/keyblock.hpp>
#include <keyblock/record.hpp>
#include <set>
#include <string>

#include "tests/library/example_cases.hpp"

namespace kb = keyblock::api;
namespace fs = std::filesystem;

namespace {

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

kb::Case slide() {
  return kb::Case::read({KEYBLOCK_SOURCE_DIR "/legacy_cases/sliding_block/a30_p20"});
}

fs::path empty_folder(const std::string& name) {
  const fs::path folder = fs::path(::testing::TempDir()) / ("keyblock_record_" + name);
  fs::remove_all(folder);
  return folder;
}

/// Names of all files below, without run.json, which holds times.
std::set<std::string> files_below(const fs::path& folder) {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().filename() != "run.json")
      names.insert(fs::relative(entry.path(), folder).string());
  return names;
}

void expect_same_results(const fs::path& a, const fs::path& b) {
  const std::set<std::string> names = files_below(a);
  EXPECT_GT(names.size(), 5U);
  EXPECT_EQ(names, files_below(b));
  for (const std::string& name : names) EXPECT_EQ(bytes_of(a / name), bytes_of(b / name)) << name;
}

}  // namespace

TEST(Record, intervals_below_zero_are_refused_before_anything_is_written) {
  const fs::path folder = empty_folder("intervals");
  EXPECT_EQ(keyblock::api_test::code_of([&] { kb::record(slide(), folder.string(), {.every = -7}); }),
            kb::ErrorCode::choice);
  EXPECT_EQ(keyblock::api_test::code_of([&] { kb::record(slide(), folder.string(), {.checkpoint_every = -5}); }),
            kb::ErrorCode::choice);
  EXPECT_TRUE(!fs::exists(folder) || fs::is_empty(folder));
}

TEST(Record, a_recorded_run_leaves_what_the_program_leaves) {
  const fs::path own = empty_folder("own"), program = empty_folder("program");
  int steps = 0;
  const kb::Outcome outcome = kb::record(slide(), own.string(), {.on_step = [&](const kb::Step&) { ++steps; }});
  EXPECT_EQ(outcome.end, kb::End::finished) << outcome.reason;
  EXPECT_EQ(steps, outcome.steps);
  const std::string command = std::string(KEYBLOCK_PROGRAM) +
                              " run " KEYBLOCK_SOURCE_DIR "/legacy_cases/sliding_block/a30_p20 --quiet -o " +
                              program.string();
  ASSERT_EQ(std::system(command.c_str()), 0);
  expect_same_results(own, program);
  EXPECT_EQ(keyblock::api_test::code_of([&] { kb::record(slide(), own.string()); }), kb::ErrorCode::choice)
      << "results are there";
  EXPECT_EQ(keyblock::api_test::code_of([&] { kb::resume(own.string()); }), kb::ErrorCode::choice) << "the run is over";
  fs::remove_all(own);
  fs::remove_all(program);
}

TEST(Record, a_run_stopped_by_its_context_is_resumed_to_the_same_bytes) {
  const fs::path whole = empty_folder("whole"), parted = empty_folder("parted");
  kb::record(slide(), whole.string());
  const kb::Context context;
  const kb::Outcome first = kb::record(slide(), parted.string(),
                                       {.on_step =
                                            [&](const kb::Step& step) {
                                              if (step.number == 9) context.stop();
                                            }},
                                       {}, context);
  EXPECT_EQ(first.end, kb::End::stopped);
  EXPECT_LT(first.steps, 20);
  const fs::path here = fs::current_path();
  const kb::Outcome second = kb::resume(parted.string());
  EXPECT_EQ(second.end, kb::End::finished) << second.reason;
  EXPECT_EQ(fs::current_path(), here);
  expect_same_results(whole, parted);
  fs::remove_all(whole);
  fs::remove_all(parted);
}

TEST(Record, a_run_that_its_caller_steps_leaves_the_same_files_and_may_end_early) {
  const fs::path whole = empty_folder("whole_run"), stepped = empty_folder("stepped");
  kb::record(slide(), whole.string());
  kb::Run run = kb::recorded(slide(), stepped.string());
  const kb::Outcome early = run.go_on([](const kb::Run& now) { return now.last().number == 9; });
  EXPECT_EQ(early.end, kb::End::stopped);
  EXPECT_EQ(early.steps, 9);
  EXPECT_FALSE(run.advance());
  EXPECT_NE(bytes_of(stepped / "run.json").find("\"ended_early\": \"" + early.reason + '"'), std::string::npos);
  const double kinetic = run.history("ledger", "kinetic")(9, 1);
  EXPECT_GT(kinetic, 0);
  EXPECT_EQ(kb::resume(stepped.string()).end, kb::End::finished);
  expect_same_results(whole, stepped);
  fs::remove_all(whole);
  fs::remove_all(stepped);
}

// Both have one build id.
TEST(Record, what_the_library_began_the_program_resumes) {
  const fs::path whole = empty_folder("whole_of_both"), parted = empty_folder("parted_of_both");
  kb::record(slide(), whole.string());
  const kb::Context context;
  const auto stop = [&](const kb::Step& step) {
    if (step.number == 9) context.stop();
  };
  EXPECT_EQ(kb::record(slide(), parted.string(), {.on_step = stop}, {}, context).end, kb::End::stopped);
  EXPECT_EQ(std::system((std::string(KEYBLOCK_PROGRAM) + " run --quiet --resume " + parted.string()).c_str()), 0);
  expect_same_results(whole, parted);
  fs::remove_all(whole);
  fs::remove_all(parted);
}
