// A run answers a request to stop at any time, and leaves results that can be resumed.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <numbers>

#include "tests/support/killed_runs.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::stops_test {
namespace {

namespace fs = std::filesystem;
using support::contents;
using support::fresh_folder;
using support::run_keyblock;
using support::run_script;

const std::string kRest = KEYBLOCK_SOURCE_DIR "/legacy_cases/block_at_rest/dynamic/dynamic";
const std::string kStack = KEYBLOCK_SOURCE_DIR "/legacy_cases/stack/five_blocks/five_blocks";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A square on a floor, cut into `count` wedges about its middle: its contact forces do not converge in ten seconds.
std::string fan(int count) {
  std::string lines =
      "[-5, -1, 15, -1, 1], [15, -1, 15, 0, 1], [15, 0, -5, 0, 1], [-5, 0, -5, -1, 1], "
      "[1, 0, 3, 0, 1], [3, 0, 3, 2, 1], [3, 2, 1, 2, 1], [1, 2, 1, 0, 1]";
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    lines += fmt::format(", [2, 1, {}, {}, 1]", 2 + 3 * std::cos(angle), 1 + 3 * std::sin(angle));
  }
  return R"({"keyblock": 1, "drawing": {"edge_node_ratio": 0.0001, "joints": [)" + lines +
         R"(], "fixed_lines": [[-4, -0.5, -4, -0.5], [14, -0.5, 14, -0.5]]}, "analysis": {"step_count": 20,
            "time_step": 0.001, "allowed_displacement_ratio": 0.01, "joint_materials": [{"friction_angle_deg": 30}],
            "block_materials": [{"density": 2500, "unit_weight": 24525, "youngs_modulus": 5000000000.0,
            "poissons_ratio": 0.25}]}})";
}

std::string slope_in(const std::string& folder) {
  const auto drawn = run_keyblock({"joints", "--slope", "height=30,angle=60,toe=5,crest=20,base=3", "--fixed",
                                   "0,0,40,0", "--set", "dip=20,spacing=1,trace=500,joint=1", "--set",
                                   "dip=110,spacing=1.1,trace=500,joint=1", "-o", folder + "/slope.geo"});
  EXPECT_EQ(drawn.exit_code, 0) << drawn.messages;
  return folder + "/slope.geo";
}

}  // namespace

// Some thousand blocks, which take seconds to reach their initial state before any message.
TEST(Stops, are_heard_while_the_start_is_sought) {
  const std::string folder = fresh_folder("stop_start");
  const std::vector<std::string> arguments{"run",
                                           slope_in(folder),
                                           KEYBLOCK_SOURCE_DIR "/legacy_cases/fronts/slope_1000.ana",
                                           "--profile",
                                           "standard",
                                           "--set",
                                           "steps=1",
                                           "-o",
                                           folder + "/out"};
  const auto stopped = support::interrupt_keyblock(arguments, folder + "/out/frames", SIGTERM);
  EXPECT_EQ(stopped.exit_code, 130) << stopped.messages;
  EXPECT_TRUE(contains(stopped.messages, "stopped by request before the first step")) << stopped.messages;
  EXPECT_FALSE(fs::exists(folder + "/out/frames/00000000.vtu"));
  EXPECT_TRUE(fs::exists(folder + "/out/checkpoint.h5"));
}

TEST(Stops, are_heard_within_a_long_step) {
  const std::string folder = fresh_folder("stop_step");
  support::write_text(folder + "/fan.json", fan(100));
  const auto stopped = support::interrupt_keyblock({"run", folder + "/fan.json", "-o", folder + "/out"},
                                                   folder + "/out/frames/00000000.vtu", SIGTERM);
  EXPECT_EQ(stopped.exit_code, 130) << stopped.messages;
  EXPECT_TRUE(fs::exists(folder + "/out/run.json"));
  EXPECT_TRUE(fs::exists(folder + "/out/checkpoint.h5"));
}

// Steps of some hundred blocks last long enough that a stop falls into one of them.
TEST(Stops, within_steps_leave_a_run_that_ends_with_the_same_bytes) {
  for (const char* profile : {"legacy", "standard"}) {
    const std::string folder = fresh_folder(std::string("stop_within_") + profile);
    std::vector<std::string> arguments{"run",
                                       slope_in(folder),
                                       KEYBLOCK_SOURCE_DIR "/legacy_cases/fronts/slope_1000.ana",
                                       "--profile",
                                       profile,
                                       "--set",
                                       "steps=5",
                                       "--set",
                                       "start=sudden",
                                       "--record-every",
                                       "1",
                                       "-o",
                                       folder + "/out"};
    for (const char* frame : {"00000000", "00000001", "00000003"}) {
      const auto stopped =
          support::interrupt_keyblock(arguments, fmt::format("{}/out/frames/{}.vtu", folder, frame), SIGTERM);
      EXPECT_TRUE(stopped.exit_code == 130 || stopped.exit_code == 0) << stopped.messages;
      if (stopped.exit_code == 0) break;
      arguments = {"run", "--resume", folder + "/out"};
    }
    if (fs::exists(folder + "/out/checkpoint.h5")) {
      const auto resumed = run_keyblock({"run", "--resume", folder + "/out"});
      EXPECT_EQ(resumed.exit_code, 0) << resumed.messages;
    }
    const auto whole = run_keyblock(
        {"run", folder + "/slope.geo", KEYBLOCK_SOURCE_DIR "/legacy_cases/fronts/slope_1000.ana", "--profile", profile,
         "--set", "steps=5", "--set", "start=sudden", "--record-every", "1", "-o", folder + "/whole"});
    ASSERT_EQ(whole.exit_code, 0) << whole.messages;
    EXPECT_TRUE(contents(folder + "/out") == contents(folder + "/whole")) << profile;
  }
}

// The process waits for a reader that does not come (the pipe is full), and cannot react. (A shell makes its background
// programs ignore SIGINT.)
TEST(Stops, asked_for_again_later_end_the_run_at_once) {
  for (const auto& [name, signal] : {std::pair{"TERM", SIGTERM}, {"HUP", SIGHUP}}) {
    const std::string folder = fresh_folder(std::string("stop_twice_") + name);
    const auto run = run_script(fmt::format(
        "cd {}\nmkfifo pipe\nsleep 60 < pipe &\nreader=$!\n"
        "{{ head -c 65536 /dev/zero; exec \"$K\" run {}.geo {}.ana --profile standard --set steps=4000 --trace --json "
        "-o out; }} > pipe &\nrun=$!\n"
        "while ! test -e out/run.json; do sleep 0.05; done\nsleep 0.3\n"
        "kill -{} $run\nsleep 1.3\nkill -{} $run\nwait $run\ncode=$?\nkill $reader\nexit $code",
        folder, kStack, kStack, name, name));
    EXPECT_EQ(run.exit_code, 128 + signal) << run.messages;
  }
}

// Acts as `timeout` does, which sends the signal to the program and to its group. The script waits for the first frame:
// a program that is still starting does not react.
TEST(Stops, asked_for_twice_at_once_are_one) {
  const std::string out = fresh_folder("stop_twice_at_once") + "/out";
  const auto run =
      run_script(fmt::format("\"$K\" run {}.geo {}.ana --profile standard --set steps=100000000 -o {} &\nrun=$!\n"
                             "while kill -0 $run && ! test -e {}/frames/00000000.vtu; do sleep 0.05; done\n"
                             "kill -TERM $run\nkill -TERM $run\nwait $run",
                             kRest, kRest, out, out));
  EXPECT_EQ(run.exit_code, 130) << run.messages;
  EXPECT_TRUE(fs::exists(out + "/checkpoint.h5"));
  EXPECT_TRUE(fs::exists(out + "/run.json"));
}

}  // namespace keyblock::stops_test
