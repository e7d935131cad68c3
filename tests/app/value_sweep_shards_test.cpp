// Sweeps and batches in shards, and sweeps that were killed or stopped: their tables are those of one undisturbed run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include "base/bytes/sha256.hpp"
#include "tests/app/value_sweeps.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::value_sweep_shards_test {
namespace {

namespace fs = std::filesystem;
using support::contains;
using support::fresh_folder;
using support::ProgramRun;
using support::read_text;
using support::run_keyblock;
using support::write_text;
using value_sweep_test::slope_in;
using value_sweep_test::sweep_of;
using value_sweep_test::Words;
using value_sweep_test::operator+;

}  // namespace

TEST(ValueSweepShards, killed_it_goes_on_and_gives_the_same_table) {
  const std::string folder = fresh_folder("value_sweep_killed");
  const std::string file = slope_in(folder);
  const Words command = sweep_of(file, folder + "/killed");
  support::kill_keyblock(command, folder + "/killed/journal.jsonl", 3);
  const ProgramRun resumed = run_keyblock(command + Words{"--resume"});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.messages;
  EXPECT_EQ(run_keyblock(sweep_of(file, folder + "/whole")).output, resumed.output);
}

TEST(ValueSweepShards, a_stopped_run_resumes_from_its_checkpoint) {
  const std::string folder = fresh_folder("value_sweep_checkpoint");
  const std::string file = slope_in(folder);
  const Words command{"sweep", file, "--over", "steps=20000", "--set", "time_step=1e-5", "-o", folder + "/out"};
  const ProgramRun stopped =
      support::interrupt_keyblock(command + Words{"--shard", "1/1"}, folder + "/out/journal.jsonl", SIGTERM);
  EXPECT_EQ(stopped.exit_code, 130) << stopped.messages;
  const ProgramRun resumed = run_keyblock(command + Words{"--resume"});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.messages;
  EXPECT_EQ(
      run_keyblock({"sweep", file, "--over", "steps=20000", "--set", "time_step=1e-5", "-o", folder + "/whole"}).output,
      resumed.output);
}

TEST(ValueSweepShards, a_shard_belongs_to_one_process_at_a_time) {
  const std::string folder = fresh_folder("value_sweep_lock");
  const std::string file = slope_in(folder);
  fs::create_directory(folder + "/out");
  const Words command{"sweep", file, "--over", "steps=2,3", "-o", folder + "/out"};
  const int lock = open((folder + "/out/.lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  struct flock byte_1 = {};
  byte_1.l_type = F_WRLCK;
  byte_1.l_start = byte_1.l_len = 1;
  ASSERT_EQ(fcntl(lock, F_OFD_SETLK, &byte_1), 0);
  const ProgramRun same = run_keyblock(command + Words{"--shard", "1/2"});
  EXPECT_EQ(same.exit_code, 2);
  EXPECT_TRUE(contains(same.messages, "another process does shard 1 of")) << same.messages;
  EXPECT_EQ(run_keyblock(command + Words{"--shard", "2/2"}).exit_code, 0);
  close(lock);
  EXPECT_EQ(run_keyblock(command + Words{"--shard", "1/2"}).exit_code, 0);
}

TEST(ValueSweepShards, a_shard_removes_no_results_of_others) {
  const std::string folder = fresh_folder("value_sweep_force");
  const Words command{"sweep", slope_in(folder), "--over", "steps=2,3", "-o", folder + "/out"};
  EXPECT_EQ(run_keyblock(command + Words{"--shard", "1/2"}).exit_code, 0);
  const ProgramRun forced = run_keyblock(command + Words{"--shard", "2/2", "--force"});
  EXPECT_EQ(forced.exit_code, 2);
  EXPECT_TRUE(contains(forced.messages, "--force would remove the results of other shards")) << forced.messages;
  EXPECT_EQ(run_keyblock(command + Words{"--shard", "2/2"}).exit_code, 0);
  EXPECT_EQ(run_keyblock(command + Words{"--merge"}).exit_code, 0);
}

TEST(ValueSweepShards, scripts_name_the_shards) {
  const std::string folder = fresh_folder("value_sweep_scripts");
  const std::string file = slope_in(folder);
  const Words command{"sweep", file, "--over", "steps=10, 20", "-o", folder + "/out"};
  const ProgramRun slurm = run_keyblock(command + Words{"--jobs", "2", "--slurm", "4"});  // a task has one job
  EXPECT_EQ(slurm.exit_code, 0);
  EXPECT_TRUE(contains(slurm.output, "#SBATCH --array=1-4")) << slurm.output;
  EXPECT_TRUE(contains(slurm.output, "--over 'steps=10, 20'")) << slurm.output;
  EXPECT_FALSE(contains(slurm.output, "--slurm"));
  EXPECT_FALSE(fs::exists(folder + "/out"));
  // The script as Slurm runs it, one task after another.
  write_text(folder + "/job.sh", slurm.output);
  for (const char* task : {"1", "2", "3", "4"})
    EXPECT_EQ(support::run_script("SLURM_ARRAY_TASK_ID=" + std::string(task) + " bash " + folder + "/job.sh").exit_code,
              0);
  EXPECT_EQ(run_keyblock(command + Words{"--merge"}).exit_code, 0);
  EXPECT_TRUE(
      contains(run_keyblock(command + Words{"--parallel", "3"}).output, "$shard/3\"; done | parallel --retries 3 ; "));
}

// A task that was stopped before its limit is running; one that scancel ended is completing.
TEST(ValueSweepShards, a_cancelled_task_of_slurm_stays_away) {
  const std::string folder = fresh_folder("value_sweep_cancelled");
  std::string script =
      run_keyblock({"sweep", slope_in(folder), "--over", "steps=10,20", "-o", folder + "/out", "--slurm", "2"}).output;
  const std::size_t end = script.find(" &\n"), begin = script.rfind('\n', end) + 1;
  ASSERT_NE(end, std::string::npos);
  script.replace(begin, end - begin, "bash -c 'exit 130'");
  write_text(folder + "/job.sh", script);
  write_text(folder + "/scontrol",
             "#!/bin/sh\necho \"$*\" >>" + folder + "/calls\necho \"JobId=7 JobState=$STATE Reason=None\"\n");
  fs::permissions(folder + "/scontrol", fs::perms::owner_all);
  const std::string task =
      " SLURM_JOB_ID=7 SLURM_ARRAY_JOB_ID=6 SLURM_ARRAY_TASK_ID=1 PATH=" + folder + ":$PATH bash " + folder + "/job.sh";
  EXPECT_EQ(support::run_script("STATE=COMPLETING" + task).exit_code, 130);
  EXPECT_EQ(read_text(folder + "/calls"), "--oneliner show job 7\n");
  EXPECT_EQ(support::run_script("STATE=RUNNING" + task).exit_code, 130);
  EXPECT_TRUE(read_text(folder + "/calls").ends_with("show job 7\nrequeue 6_1\n"));
}

TEST(ValueSweepShards, shards_of_a_batch_have_one_catalogue) {
  const std::string folder = fresh_folder("batch_shards");
  fs::create_directories(folder + "/archive");
  for (const char* kind : {"block", "slope", "arch", "beam"})
    run_keyblock({"new", kind, "-o", folder + "/archive/" + kind + ".json"});
  const Words batch{"batch", folder + "/archive", "--check"};
  ASSERT_EQ(run_keyblock(batch + Words{"-o", folder + "/whole"}).exit_code, 0);
  for (const char* shard : {"1/3", "2/3", "3/3"})
    EXPECT_EQ(run_keyblock(batch + Words{"-o", folder + "/shards", "--shard", shard}).exit_code, 0);
  EXPECT_EQ(run_keyblock(batch + Words{"-o", folder + "/shards", "--merge"}).exit_code, 0);
  for (const char* name : {"/catalogue.csv", "/catalogue.json", "/catalogue.html"})
    EXPECT_EQ(read_text(folder + "/whole" + name), read_text(folder + "/shards" + name)) << name;
}

TEST(ValueSweepShards, rows_of_changed_files_hide_no_new_ones) {
  const std::string folder = fresh_folder("batch_stale_rows");
  fs::create_directories(folder + "/archive");
  const Words batch{"batch", folder + "/archive", "--check", "-o", folder + "/out"};
  std::vector<std::string> files;
  for (const char* kind : {"block", "slope", "arch", "beam"})
    run_keyblock({"new", kind, "-o", files.emplace_back(folder + "/archive/" + kind + ".json")});
  for (const char* shard : {"1/2", "2/2"}) EXPECT_EQ(run_keyblock(batch + Words{"--shard", shard}).exit_code, 0);
  for (const std::string& file : files) write_text(file, read_text(file) + "\n");
  EXPECT_EQ(run_keyblock(batch + Words{"--merge"}).exit_code, 2);
  for (const char* shard : {"1/3", "2/3", "3/3"}) EXPECT_EQ(run_keyblock(batch + Words{"--shard", shard}).exit_code, 0);
  const ProgramRun merged = run_keyblock(batch + Words{"--merge"});
  EXPECT_EQ(merged.exit_code, 0) << merged.messages;
  const std::string catalogue = read_text(folder + "/out/catalogue.csv");
  for (const std::string& file : files) EXPECT_TRUE(contains(catalogue, sha256(read_text(file)).substr(0, 60))) << file;
}

}  // namespace keyblock::value_sweep_shards_test
