// The folder of a run holds the files of the run and those of the user: none is lost, mixed up or mistaken.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "job/run_folder.hpp"
#include "tests/support/killed_runs.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::result_folder_test {
namespace {

namespace fs = std::filesystem;
using support::contents;
using support::fresh_folder;
using support::read_text;
using support::run_keyblock;
using support::write_text;

const std::string kStack = KEYBLOCK_SOURCE_DIR "/legacy_cases/stack/five_blocks/five_blocks";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::vector<std::string> stack_into(const std::string& out, const std::string& steps = "4000") {
  return {"run", kStack + ".geo", kStack + ".ana", "--profile", "standard", "--set", "steps=" + steps, "-o", out};
}

void stop_after_frame_80(const std::string& out, const std::string& steps = "4000",
                         const std::vector<std::string>& more = {}) {
  auto words = stack_into(out, steps);
  words.insert(words.end(), more.begin(), more.end());
  const auto run = support::interrupt_keyblock(words, out + "/frames/00000080.vtu");
  ASSERT_EQ(run.exit_code, 130) << run.messages;
}

void expect_refused_unchanged(const std::string& out, const std::string& sentence) {
  const auto before = contents(out);
  const auto run = run_keyblock({"run", "--resume", out});
  EXPECT_EQ(run.exit_code, 3) << run.messages;
  EXPECT_TRUE(contains(run.messages, sentence)) << run.messages;
  EXPECT_TRUE(contents(out) == before);
}

const char* const kNotARuns = "a note of the user's";

}  // namespace

TEST(ResultFolder, resuming_leaves_what_no_run_wrote) {
  const std::string out = fresh_folder("foreign") + "/out";
  stop_after_frame_80(out);
  const std::vector<std::string> notes{"/notes.txt", "/steps.csv", "/frames/notes.txt", "/frames/80.vtu"};
  for (const std::string& name : notes) write_text(out + name, kNotARuns);
  fs::create_directory(out + "/frames/00000080.vtu.d");
  const auto run = run_keyblock({"run", "--resume", out});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  for (const std::string& name : notes) EXPECT_EQ(read_text(out + name), kNotARuns) << name;
  EXPECT_TRUE(fs::exists(out + "/frames/00000080.vtu.d"));
}

TEST(ResultFolder, a_run_leaves_at_most_a_dozen_files_beside_its_frames) {
  const std::string out = fresh_folder("dozen") + "/out", chosen = out + "_of_histories";
  const std::string slide = KEYBLOCK_SOURCE_DIR "/legacy_cases/sliding_block/a30_p20";
  const auto files_in = [](const std::string& folder) {
    return std::ranges::count_if(fs::directory_iterator(folder),
                                 [](const auto& entry) { return entry.is_regular_file(); });
  };
  ASSERT_EQ(run_keyblock({"run", slide, "-o", out}).exit_code, 0);
  EXPECT_LE(files_in(out), 12);
  EXPECT_FALSE(fs::exists(out + "/histories.csv")) << "the measured point has tables of its own";
  ASSERT_EQ(run_keyblock({"run", slide, "-o", chosen, "--history", "block:2"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(chosen + "/histories.csv"));
}

TEST(ResultFolder, force_overwrites_results_and_leaves_the_rest) {
  const std::string out = fresh_folder("forced") + "/out";
  ASSERT_EQ(run_keyblock(stack_into(out, "400")).exit_code, 0);
  fs::create_directory(out + "/frames/mine");
  write_text(out + "/frames/mine/notes.txt", kNotARuns);
  write_text(out + "/frames/notes.txt", kNotARuns);
  auto again = stack_into(out, "4");
  again.emplace_back("--force");
  EXPECT_EQ(run_keyblock(again).exit_code, 0);
  EXPECT_EQ(read_text(out + "/frames/notes.txt"), kNotARuns);
  EXPECT_EQ(read_text(out + "/frames/mine/notes.txt"), kNotARuns);
  EXPECT_FALSE(fs::exists(out + "/frames/00000400.vtu")) << "a frame of the earlier run";
  EXPECT_TRUE(fs::exists(out + "/frames/00000004.vtu"));
}

TEST(ResultFolder, force_leaves_files_that_only_bear_the_name_of_a_result) {
  const std::string out = fresh_folder("forced_names") + "/out";
  ASSERT_EQ(run_keyblock(stack_into(out, "4")).exit_code, 0);
  write_text(out + "/steps.csv", kNotARuns);  // the run had no trace
  auto again = stack_into(out, "4");
  again.emplace_back("--force");
  EXPECT_EQ(run_keyblock(again).exit_code, 0);
  EXPECT_EQ(read_text(out + "/steps.csv"), kNotARuns);
}

TEST(ResultFolder, drafts_of_a_killed_run_go_and_the_user_s_drafts_stay) {
  const std::string out = fresh_folder("drafts") + "/out";
  stop_after_frame_80(out);
  write_text(out + "/.keyblock_draft_1_0", "half a file");
  write_text(out + "/frames/.keyblock_draft_1_7", "half a file");
  write_text(out + "/checkpoint.h5.part", kNotARuns);
  EXPECT_EQ(run_keyblock({"run", "--resume", out}).exit_code, 0);
  EXPECT_FALSE(fs::exists(out + "/.keyblock_draft_1_0"));
  EXPECT_FALSE(fs::exists(out + "/frames/.keyblock_draft_1_7"));
  EXPECT_EQ(read_text(out + "/checkpoint.h5.part"), kNotARuns);
}

// A run that is killed as it writes its first checkpoint leaves a draft and nothing else: the folder holds no results.
TEST(ResultFolder, a_draft_of_a_run_killed_at_once_goes_with_the_next_run) {
  const std::string out = fresh_folder("early_draft") + "/out";
  fs::create_directory(out);
  write_text(out + "/.keyblock_draft_1_0", "half a checkpoint");
  EXPECT_EQ(run_keyblock(stack_into(out, "4")).exit_code, 0);
  EXPECT_FALSE(fs::exists(out + "/.keyblock_draft_1_0"));
}

TEST(ResultFolder, drafts_of_a_killed_batch_go_too) {
  const std::string folder = fresh_folder("batch_drafts");
  fs::create_directory(folder + "/in");
  for (const char* ending : {".geo", ".ana"}) fs::copy_file(kStack + ending, folder + "/in/stack" + ending);
  const std::vector<std::string> batch{"batch", folder + "/in", "--check", "-o", folder + "/out"};
  ASSERT_EQ(run_keyblock(batch).exit_code, 0);
  write_text(folder + "/out/.keyblock_draft_1_0", "half a file");
  auto resumed = batch;
  resumed.emplace_back("--resume");
  EXPECT_EQ(run_keyblock(resumed).exit_code, 0);
  EXPECT_FALSE(fs::exists(folder + "/out/.keyblock_draft_1_0"));
}

TEST(ResultFolder, a_frame_that_was_changed_or_cut_short_is_refused) {
  const std::string out = fresh_folder("damaged_frame") + "/out";
  stop_after_frame_80(out);
  const std::string frame = out + "/frames/00000040.vtu";
  const std::string bytes = read_text(frame);
  write_text(frame, bytes.substr(0, 100));
  expect_refused_unchanged(out, "expected every frame as it was written, found one changed");
  std::string other = bytes;
  other[bytes.size() / 2] ^= 1;
  write_text(frame, other);
  expect_refused_unchanged(out, "found one changed (folder: frames/00000040.vtu)");
  write_text(frame, bytes);
  EXPECT_EQ(run_keyblock({"run", "--resume", out}).exit_code, 0);
}

// The rows before the checkpoint are in no other place.
TEST(ResultFolder, a_growing_table_that_was_removed_cut_or_changed_is_refused) {
  const std::string out = fresh_folder("altered_tables") + "/out";
  stop_after_frame_80(out, "4000", {"--history", "block:1"});
  for (const char* name : {"contacts.csv", "joints.csv", "histories.csv"}) {
    const std::string file = out + "/" + name;
    const std::string whole = read_text(file);
    std::string flipped = whole;
    flipped[whole.size() / 3] ^= 1;
    for (const std::string& altered : {whole.substr(0, whole.size() / 2), flipped, std::string()}) {
      write_text(file, altered);
      if (altered.empty()) fs::remove(file);
      const auto before = support::contents(out);
      const auto run = run_keyblock({"run", "--resume", out});
      EXPECT_EQ(run.exit_code, 3) << name;
      EXPECT_NE(run.messages.find(file + ": error: expected the first "), std::string::npos) << run.messages;
      EXPECT_TRUE(support::contents(out) == before);
    }
    write_text(file, whole + "behind the checkpoint\n");
  }
  EXPECT_EQ(run_keyblock({"run", "--resume", out}).exit_code, 0);
  EXPECT_EQ(read_text(out + "/contacts.csv").find("behind the checkpoint"), std::string::npos);
}

TEST(ResultFolder, the_checkpoint_of_another_run_is_refused) {
  const std::string folder = fresh_folder("other_run");
  stop_after_frame_80(folder + "/a");
  stop_after_frame_80(folder + "/b", "8000");
  fs::copy_file(folder + "/a/checkpoint.h5", folder + "/b/checkpoint.h5", fs::copy_options::overwrite_existing);
  expect_refused_unchanged(folder + "/b", "found that of a run in " + folder + "/a, which still exists");
  // Nor if the other folder is gone: its frames are not these.
  fs::remove_all(folder + "/a");
  fs::remove(folder + "/b/frames/00000080.vtu");
  expect_refused_unchanged(folder + "/b", "found one");
}

TEST(ResultFolder, a_folder_that_was_moved_is_gone_on_with) {
  const std::string folder = fresh_folder("moved");
  stop_after_frame_80(folder + "/first");
  fs::rename(folder + "/first", folder + "/then");
  const auto run = run_keyblock({"run", "--resume", folder + "/then"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  ASSERT_EQ(run_keyblock(stack_into(folder + "/whole")).exit_code, 0);
  EXPECT_TRUE(contents(folder + "/then") == contents(folder + "/whole"));
}

TEST(ResultFolder, a_folder_taken_away_ends_the_run_and_is_not_made_again) {
  const std::string folder = fresh_folder("taken_away");
  const auto run = run_keyblock(stack_into(folder + "/out", "1000000"), folder + "/out/frames/00000000.vtu",
                                [&] { fs::rename(folder + "/out", folder + "/elsewhere"); });
  EXPECT_EQ(run.exit_code, 4) << run.messages;
  // A frame, or the table of contacts beside it: the first file written after that.
  EXPECT_TRUE(contains(run.messages, "cannot write " + folder + "/out/")) << run.messages;
  EXPECT_FALSE(fs::exists(folder + "/out"));
  EXPECT_TRUE(fs::exists(folder + "/elsewhere/checkpoint.h5"));
}

TEST(ResultFolder, a_list_of_frames_names_none_that_is_gone) {
  const std::string folder = fresh_folder("frame_gone");
  std::vector<std::string> words = stack_into(folder + "/out");
  words.insert(words.end(), {"--checkpoint-every", "0"});  // each writes a list of the frames that there are
  const auto run = run_keyblock(words, folder + "/out/frames/00000080.vtu",
                                [&] { fs::remove(folder + "/out/frames/00000040.vtu"); });
  EXPECT_EQ(run.exit_code, 4) << run.messages;
  EXPECT_TRUE(contains(run.messages, "00000040.vtu")) << run.messages;
  EXPECT_FALSE(fs::exists(folder + "/out/fields.pvd"));
}

TEST(ResultFolder, input_refused_late_leaves_nothing_and_loses_nothing) {
  const std::string folder = fresh_folder("refused_late");
  std::string text = read_text(KEYBLOCK_SOURCE_DIR "/legacy_cases/cook_membrane/coarse/coarse.json");
  write_text(folder + "/right.json", text);
  const std::string load = "\"y\": \"1/16\"";
  ASSERT_TRUE(contains(text, load)) << text;
  text.replace(text.find(load), load.size(), "\"y\": \"1/0\"");
  write_text(folder + "/wrong.json", text);
  const auto refused = run_keyblock({"run", folder + "/wrong.json", "-o", folder + "/out"});
  EXPECT_EQ(refused.exit_code, 3) << refused.messages;
  EXPECT_FALSE(fs::exists(folder + "/out"));
  ASSERT_EQ(run_keyblock({"run", folder + "/right.json", "-o", folder + "/out"}).exit_code, 0);
  const auto before = contents(folder + "/out");
  EXPECT_EQ(run_keyblock({"run", folder + "/wrong.json", "-o", folder + "/out", "--force"}).exit_code, 3);
  EXPECT_TRUE(contents(folder + "/out") == before);
}

// No file may grow: not even the first checkpoint can be written.
TEST(ResultFolder, frames_come_after_the_first_checkpoint) {
  const std::string out = fresh_folder("no_checkpoint") + "/out";
  const auto run = support::run_script("ulimit -f 0; exec \"$K\" run " + kStack + ".geo " + kStack +
                                       ".ana --profile standard -o " + out);
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_FALSE(fs::exists(out + "/frames"));
  EXPECT_FALSE(fs::exists(out + "/checkpoint.h5"));
  EXPECT_EQ(run_keyblock(stack_into(out, "4")).exit_code, 0) << "nothing is in its way";
}

TEST(ResultFolder, what_came_to_stand_there_after_it_was_looked_at_is_not_lost) {
  const std::string out = fresh_folder("race") + "/out";
  RunFolder late(out, Overwrite::no, Trace::no);
  RunFolder(out, Overwrite::no, Trace::no).begin("of the other run");
  EXPECT_THROW(late.begin("of this run"), UsageError);
  EXPECT_EQ(read_text(out + "/checkpoint.h5"), "of the other run");
  const std::string other = fresh_folder("record") + "/out";
  RunFolder folder(other, Overwrite::no, Trace::no);
  folder.begin();
  write_text(other + "/run.json", kNotARuns);
  EXPECT_THROW(folder.write_record("{}"), UsageError);
  EXPECT_EQ(read_text(other + "/run.json"), kNotARuns);
}

TEST(ResultFolder, of_a_run_that_still_writes_is_neither_resumed_nor_overwritten) {
  const std::string out = fresh_folder("live") + "/out";
  const std::string whole = fresh_folder("live_whole") + "/out";
  support::ProgramRun resumed, overwritten;
  const auto run = run_keyblock(stack_into(out), out + "/frames/00000080.vtu", [&] {
    resumed = run_keyblock({"run", "--resume", out});
    std::vector<std::string> again = stack_into(out);
    again.emplace_back("--force");
    overwritten = run_keyblock(again);
  });
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  for (const support::ProgramRun* refused : {&resumed, &overwritten}) {
    EXPECT_EQ(refused->exit_code, 2) << refused->messages;
    EXPECT_TRUE(contains(refused->messages, "another run is writing to")) << refused->messages;
  }
  EXPECT_EQ(run_keyblock(stack_into(whole)).exit_code, 0);
  EXPECT_TRUE(contents(out) == contents(whole));
}

TEST(ResultFolder, a_file_overwritten_keeps_its_permissions) {
  const std::string out = fresh_folder("permissions");
  const fs::path file = out + "/a.svg";
  write_text(file, "old");
  const fs::perms own = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_write;
  fs::permissions(file, own);
  write_file(file, "new");
  EXPECT_EQ(read_text(file), "new");
  EXPECT_EQ(fs::status(file).permissions(), own);
  EXPECT_THROW(write_output(file, "newer", Overwrite::no), UsageError);
  EXPECT_EQ(read_text(file), "new");
}

TEST(ResultFolder, a_link_in_place_of_the_frames_is_refused_by_force_too) {
  const std::string folder = fresh_folder("linked");
  fs::create_directories(folder + "/other");
  fs::create_directories(folder + "/out");
  write_text(folder + "/other/20260101.vtu", kNotARuns);
  fs::create_directory_symlink(folder + "/other", folder + "/out/frames");
  std::vector<std::string> arguments = stack_into(folder + "/out", "4");
  arguments.emplace_back("--force");
  const auto run = run_keyblock(arguments);
  EXPECT_EQ(run.exit_code, 2) << run.messages;
  EXPECT_EQ(read_text(folder + "/other/20260101.vtu"), kNotARuns);
}

TEST(ResultFolder, a_batch_begun_again_leaves_what_no_job_wrote) {
  const std::string folder = fresh_folder("batch_again");
  fs::create_directories(folder + "/in");
  fs::copy_file(kStack + ".geo", folder + "/in/stack.geo");
  fs::copy_file(kStack + ".ana", folder + "/in/stack.ana");
  const std::vector<std::string> batch{"batch", folder + "/in", "--run", "-o", folder + "/out"};
  ASSERT_EQ(run_keyblock(batch).exit_code, 0);
  write_text(folder + "/out/jobs/notes.txt", kNotARuns);
  std::vector<std::string> again = batch;
  again.emplace_back("--force");
  EXPECT_EQ(run_keyblock(again).exit_code, 0);
  EXPECT_EQ(read_text(folder + "/out/jobs/notes.txt"), kNotARuns);
}

TEST(ResultFolder, without_pictures_all_else_is_there_and_plot_draws_from_the_frames) {
  const std::string folder = fresh_folder("no_pictures");
  auto words = stack_into(folder + "/bare", "20");
  words.emplace_back("--no-pictures");
  ASSERT_EQ(run_keyblock(stack_into(folder + "/whole", "20")).exit_code, 0);
  ASSERT_EQ(run_keyblock(words).exit_code, 0);
  int pictures = 0;
  for (const auto& entry : fs::directory_iterator(folder + "/whole")) {
    const bool is_picture = entry.path().extension() == ".svg";
    pictures += is_picture ? 1 : 0;
    EXPECT_EQ(fs::exists(fs::path(folder) / "bare" / entry.path().filename()), !is_picture) << entry.path();
  }
  EXPECT_GE(pictures, 3);
  EXPECT_FALSE(contains(read_text(folder + "/bare/run.json"), ".svg"));
  EXPECT_EQ(run_keyblock({"plot", folder + "/bare"}).exit_code, 0);
}

}  // namespace keyblock::result_folder_test
