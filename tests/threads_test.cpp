// Steps on several threads from the command line: the bytes are those of one thread, and of a run that was stopped and
// resumed.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <csignal>

#include "tests/support/killed_runs.hpp"
#include "tests/support/program.hpp"

namespace keyblock::threads_test {
namespace {

using support::contents;
using support::run_keyblock;

/// A jointed slope of some hundred blocks, whose contacts threads share (tests/step/threads_test.cpp: more blocks).
class ThreadedRuns : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    folder_ = support::fresh_folder(std::string("threads_") + GetParam());
    const auto drawn = run_keyblock({"joints", "--slope", "height=30,angle=60,toe=5,crest=20,base=3", "--fixed",
                                     "0,0,40,0", "--set", "dip=20,spacing=1.5,trace=500,joint=1", "--set",
                                     "dip=110,spacing=1.6,trace=500,joint=1", "-o", folder_ + "/slope.geo"});
    ASSERT_EQ(drawn.exit_code, 0) << drawn.messages;
  }

  std::vector<std::string> command(const std::string& threads, const std::string& out) const {
    return {"run",
            folder_ + "/slope.geo",
            KEYBLOCK_SOURCE_DIR "/legacy_cases/fronts/slope_1000.ana",
            "--profile",
            GetParam(),
            "--set",
            "steps=6",
            "--set",
            "start=sudden",
            "--trace",
            "--threads",
            threads,
            "-o",
            folder_ + "/" + out};
  }

  std::string folder_;
};

TEST_P(ThreadedRuns, have_the_same_bytes_on_1_2_and_4_threads_and_resumed) {
  for (const char* threads : {"1", "2", "4"}) {
    const auto run = run_keyblock(command(threads, threads));
    ASSERT_EQ(run.exit_code, 0) << run.messages;
  }
  const auto one = contents(folder_ + "/1");
  EXPECT_TRUE(one == contents(folder_ + "/2"));
  EXPECT_TRUE(one == contents(folder_ + "/4"));
  auto stopped = command("2", "stopped");
  const auto killed = support::interrupt_keyblock(stopped, folder_ + "/stopped/frames/00000002.vtu");
  ASSERT_EQ(killed.exit_code, 130) << killed.messages;
  const auto resumed = run_keyblock({"run", "--resume", folder_ + "/stopped", "--threads", "4"});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.messages;
  EXPECT_TRUE(one == contents(folder_ + "/stopped"));
}

INSTANTIATE_TEST_SUITE_P(Profiles, ThreadedRuns, ::testing::Values("legacy", "standard"));

}  // namespace
}  // namespace keyblock::threads_test
