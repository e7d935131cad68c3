// `run --resume` from the command line: killed or stopped runs end with the bytes of the undisturbed run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

#include "base/bytes/build_id.hpp"
#include "tests/support/killed_runs.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::resume_test {
namespace {

namespace fs = std::filesystem;
using support::fresh_folder;
using support::run_keyblock;

const std::string kStack = std::string(KEYBLOCK_SOURCE_DIR) + "/legacy_cases/stack/five_blocks/five_blocks";

/// A stack copied into a folder of its own, stopped after its first frames.
struct StoppedRun {
  std::string folder;
  std::string out;
  std::vector<std::string> arguments;

  explicit StoppedRun(const std::string& name) : folder(fresh_folder(name)), out(folder + "/out") {
    for (const char* ending : {".geo", ".ana"}) fs::copy_file(kStack + ending, folder + "/stack" + ending);
    arguments = {
        "run", folder + "/stack.geo", folder + "/stack.ana", "--profile", "standard", "--set", "steps=4000", "-o", out};
    const auto run = support::interrupt_keyblock(arguments, out + "/frames/00000080.vtu");
    EXPECT_EQ(run.exit_code, 130) << run.messages;
    EXPECT_NE(run.messages.find("\n  help: keyblock run --resume " + out + " continues it"), std::string::npos)
        << run.messages;
  }
};

}  // namespace

TEST(Resume, a_killed_run_goes_on_and_ends_with_the_same_bytes) {
  for (const char* profile : {"legacy", "standard"}) {
    const auto runs = support::killed_runs(
        {kStack + ".geo", kStack + ".ana", "--profile", profile, "--trace", "--set", "steps=500"}, 2, 1);
    EXPECT_EQ(runs.differs, "") << profile;
    EXPECT_GT(runs.resumed, 0) << profile;
  }
}

TEST(Resume, a_run_killed_before_its_first_checkpoint_begins_again_and_ends_with_the_same_bytes) {
  const std::string folder = fresh_folder("before_checkpoint");
  const std::vector<std::string> arguments{"run",     kStack + ".geo", kStack + ".ana", "--profile", "standard",
                                           "--trace", "--set",         "steps=400",     "-o"};
  const auto into = [&](const std::string& out) {
    auto all = arguments;
    all.push_back(folder + out);
    return all;
  };
  const auto killed = support::interrupt_keyblock(into("/out"), folder + "/out/frames/00000008.vtu", SIGKILL);
  ASSERT_EQ(killed.exit_code, 128 + SIGKILL);
  const auto resumed = run_keyblock({"run", "--resume", folder + "/out"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.messages;
  EXPECT_NE(resumed.messages.find("no checkpoint was saved; starting again from step 1"), std::string::npos)
      << resumed.messages;
  EXPECT_EQ(run_keyblock(into("/whole")).exit_code, 0);
  EXPECT_TRUE(support::contents(folder + "/out") == support::contents(folder + "/whole"));
}

TEST(Resume, a_stopped_run_goes_on_and_its_checkpoint_goes_at_the_end) {
  const StoppedRun stopped("stopped");
  EXPECT_TRUE(fs::exists(stopped.out + "/checkpoint.h5"));
  const auto resumed = run_keyblock({"run", "--resume", stopped.out});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.messages;
  const auto ends = support::contents(stopped.out);
  EXPECT_FALSE(ends.contains("checkpoint.h5"));
  auto whole = stopped.arguments;
  whole.back() = stopped.folder + "/whole";
  EXPECT_EQ(run_keyblock(whole).exit_code, 0);
  EXPECT_TRUE(ends == support::contents(stopped.folder + "/whole"));
  const auto again = run_keyblock({"run", "--resume", stopped.out});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_NE(again.messages.find("nothing to resume"), std::string::npos) << again.messages;
}

TEST(Resume, inputs_that_changed_are_refused_and_nothing_is_lost) {
  const StoppedRun stopped("changed");
  const auto before = support::contents(stopped.out);
  const std::string analysis = support::read_text(stopped.folder + "/stack.ana");
  support::write_text(stopped.folder + "/stack.ana", analysis + "\n");
  const auto refused = run_keyblock({"run", "--resume", stopped.out});
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_NE(refused.messages.find("stack.ana: error: expected the file that the run began with"), std::string::npos)
      << refused.messages;
  EXPECT_TRUE(support::contents(stopped.out) == before);
}

TEST(Resume, another_build_of_the_program_is_refused_and_nothing_is_lost) {
  const StoppedRun stopped("other_build");
  const auto before = support::contents(stopped.out);
  const std::string other = stopped.folder + "/keyblock";
  std::string program = support::read_text(KEYBLOCK_PROGRAM);
  const std::size_t at = program.find(build_id());
  ASSERT_NE(at, std::string::npos);
  program[at] = program[at] == '0' ? '1' : '0';
  support::write_text(other, program);
  fs::permissions(other, fs::perms::owner_all);
  const std::string messages = stopped.folder + "/messages";
  const int status = std::system((other + " run --resume " + stopped.out + " 2> " + messages).c_str());
  EXPECT_EQ(WEXITSTATUS(status), 3);
  EXPECT_NE(support::read_text(messages).find("expected the build of keyblock that began the run"), std::string::npos)
      << support::read_text(messages);
  EXPECT_TRUE(support::contents(stopped.out) == before);
}

TEST(Resume, a_damaged_checkpoint_is_refused_and_nothing_is_lost) {
  const StoppedRun stopped("damaged");
  const std::string file = stopped.out + "/checkpoint.h5";
  const std::string bytes = support::read_text(file);
  support::write_text(file, bytes.substr(0, bytes.size() / 2));
  const auto before = support::contents(stopped.out);
  const auto refused = run_keyblock({"run", "--resume", stopped.out});
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_NE(refused.messages.find("checkpoint.h5: error: expected the bytes that were saved"), std::string::npos)
      << refused.messages;
  EXPECT_TRUE(support::contents(stopped.out) == before);
  support::write_text(file, bytes);
  fs::remove(stopped.out + "/frames/00000000.vtu");
  const auto incomplete = run_keyblock({"run", "--resume", stopped.out});
  EXPECT_EQ(incomplete.exit_code, 3);
  EXPECT_NE(incomplete.messages.find("found one gone"), std::string::npos) << incomplete.messages;
}

TEST(Resume, takes_the_run_as_it_was_asked_and_nothing_else) {
  for (const char* option :
       {"--profile=legacy", "--set=steps=3", "--record-every=2", "--trace", "--force", "-o=x", "a.geo"})
    EXPECT_EQ(run_keyblock({"run", "--resume", "nowhere", option}).exit_code, 2) << option;
  const auto nowhere = run_keyblock({"run", "--resume", "nowhere"});
  EXPECT_EQ(nowhere.exit_code, 2);
  EXPECT_NE(nowhere.messages.find("checkpoint.h5, found none; begin a new run there"), std::string::npos)
      << nowhere.messages;
  const std::string over = support::fresh_folder("resume_over");
  support::write_text(over + "/run.json", "{}");
  EXPECT_NE(run_keyblock({"run", "--resume", over}).messages.find("the run in " + over + " has finished"),
            std::string::npos);
}

}  // namespace keyblock::resume_test
