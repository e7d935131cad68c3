// Closed or full streams, and limits of the shell: a run continues if it can, and reports each output that it could not
// write.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/killed_runs.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::streams_and_limits_test {
namespace {

namespace fs = std::filesystem;
using support::contents;
using support::fresh_folder;
using support::run_keyblock;
using support::run_script;

const std::string kStack = KEYBLOCK_SOURCE_DIR "/legacy_cases/stack/five_blocks/five_blocks";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string run_of(int steps) {
  return fmt::format("\"$K\" run {}.geo {}.ana --profile standard --set steps={} ", kStack, kStack, steps);
}

}  // namespace

// The first file that is opened gets the number of a closed stream.
TEST(StreamsAndLimits, messages_that_nobody_reads_neither_end_a_run_nor_go_into_its_files) {
  const std::string folder = fresh_folder("no_stderr");
  ASSERT_EQ(run_script(run_of(400) + "-o " + folder + "/whole").exit_code, 0);
  const auto whole = contents(folder + "/whole");
  for (const char* stream : {"2>&-", "2>/dev/full", "0<&- 1>&- 2>&-"}) {
    const auto run = run_script(fmt::format("{} -o {}/out --force {}", run_of(400), folder, stream));
    EXPECT_EQ(run.exit_code, 0) << stream;
    EXPECT_TRUE(contents(folder + "/out") == whole) << stream;
  }
}

TEST(StreamsAndLimits, data_that_a_full_disk_does_not_take_are_exit_4_and_the_results_stand) {
  const std::string folder = fresh_folder("no_stdout");
  const auto run = run_script(fmt::format("{} -o {}/out --force --json >/dev/full", run_of(400), folder));
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_TRUE(contains(run.messages, "cannot write to standard output")) << run.messages;
  EXPECT_TRUE(fs::exists(folder + "/out/run.json"));
}

// The folder holds the record too, for a user who closed the stream.
TEST(StreamsAndLimits, a_run_whose_record_nobody_reads_ends_as_its_results_do) {
  const std::string folder = fresh_folder("closed_stdout");
  ASSERT_EQ(run_script(run_of(400) + "-o " + folder + "/whole").exit_code, 0);
  for (const char* reader : {"exec {} >&-", "{{ {}; echo $? >code; }} | true; exit $(cat code)"}) {
    const std::string words = run_of(400) + "-o out --force --json";
    const auto run = run_script("cd " + folder + "; " + fmt::format(fmt::runtime(reader), words));
    EXPECT_EQ(run.exit_code, 0) << reader << run.messages;
    EXPECT_TRUE(contains(run.messages, "standard output is closed: the record is in")) << run.messages;
    EXPECT_TRUE(contents(folder + "/out") == contents(folder + "/whole")) << reader;
  }
}

TEST(StreamsAndLimits, a_file_that_may_not_grow_is_exit_4_and_the_run_can_be_resumed) {
  const std::string folder = fresh_folder("file_limit");
  const auto run = run_script("ulimit -f 60; exec " + run_of(4000) + "-o " + folder + "/out");
  EXPECT_EQ(run.exit_code, 4) << run.messages;
  EXPECT_TRUE(contains(run.messages, "File too large")) << run.messages;
  const auto resumed = run_keyblock({"run", "--resume", folder + "/out"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.messages;
  ASSERT_EQ(run_script(run_of(4000) + "-o " + folder + "/whole").exit_code, 0);
  EXPECT_TRUE(contents(folder + "/out") == contents(folder + "/whole"));
}

// Below some size the loader finds no room for the libraries, or one of them none for itself, before the program
// begins.
TEST(StreamsAndLimits, too_little_memory_is_exit_5_however_little) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer reserves more than any limit";
#endif
  const std::string folder = fresh_folder("memory_limits");
  int limited = 0;
  for (int kibibytes = 40000; kibibytes <= 120000; kibibytes += 4000) {
    const auto run =
        run_script(fmt::format("ulimit -v {}; exec {} --threads 4 -o {}/{}", kibibytes, run_of(4), folder, kibibytes));
    if (run_script(fmt::format("ulimit -v {}; exec {} --version", kibibytes, KEYBLOCK_PROGRAM)).exit_code != 0)
      continue;
    EXPECT_TRUE(run.exit_code == 0 || run.exit_code == 5) << kibibytes << ": " << run.exit_code << run.messages;
    if (run.exit_code == 5) {
      ++limited;
      EXPECT_TRUE(contains(run.messages, "not enough memory")) << run.messages;
    }
  }
  EXPECT_GT(limited, 0);
}

// The exit handler of HDF5 would crash on a file that is left half made.
TEST(StreamsAndLimits, a_run_that_says_that_memory_is_short_exits_5) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer reserves more than any limit";
#endif
  const std::string folder = fresh_folder("short_of_memory");
  int said = 0;
  for (int kibibytes = 34000; kibibytes <= 48000; kibibytes += 500) {
    const auto run =
        run_script(fmt::format("ulimit -v {}; exec {} --threads 1 -o {}/{}", kibibytes, run_of(4), folder, kibibytes));
    if (!contains(run.messages, "not enough memory")) continue;
    ++said;
    EXPECT_EQ(run.exit_code, 5) << kibibytes << run.messages;
  }
  EXPECT_GT(said, 0);
}

}  // namespace keyblock::streams_and_limits_test
