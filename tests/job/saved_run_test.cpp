// The contents of a checkpoint beside the stepper, restored from its bytes; and checkpoints of another run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/saved_run.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <thread>

#include "base/context.hpp"
#include "job/recorded_run.hpp"
#include "run/checkpoint.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::saved_run_test {
namespace {

using support::fresh_folder;
using support::read_text;
using support::write_text;

/// Every member differs from its default.
RunRequest request() {
  return {.program = this_program(),
          .folder = "/results/a \"b\"",
          .working_folder = "/work",
          .files = {"slope.geo", "slope.ana"},
          .profile = "standard",
          .sets = {"time_step=0.001", "steps=5"},
          .record_every = 7,
          .has_trace = true,
          .read = {"slope.geo", "slope.ana", "motion.csv"},
          .digests = {"11", "22", "33"},
          .settings = {"a=1", "b=2"},
          .histories = {"point 1"},
          .contacts = "all",
          .field = "sxx",
          .unit = "mm",
          .join = 0.1,
          .frames = "raw",
          .has_pictures = false,
          .has_page = true,
          .checkpoint_every = 7};
}

/// Returns the request in the bytes.
RunRequest restored(const std::string& bytes) {
  Archive archive = archive_of_checkpoint("checkpoint.h5", bytes);
  RunRequest found;
  archive.group("request", [&] { describe(archive, found); });
  return found;
}

template <class Error>
std::string complaint(const std::function<void()>& about) {
  try {
    about();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Makes one step, then stops with a checkpoint. Returns the interval of checkpoints in it.
double interval_after_one_step(RecordedRun& run) {
  run.open();
  run.start({});
  EXPECT_TRUE(run.step());
  run.end_early("seen");
  while (run.step()) {
  }
  return restored(read_text(checkpoint_in(run.folder()))).checkpoint_every;
}

}  // namespace

TEST(SavedRun, a_resumed_run_keeps_its_interval_of_checkpoints_unless_another_is_given) {
  const std::string folder = fresh_folder("saved_run_interval") + "/out";
  const auto in_own_context = [](const auto& work) {
    const Context own;
    const Under under(own);
    return work();
  };
  EXPECT_EQ(in_own_context([&] {
              RecordedRun run(asked_case({{KEYBLOCK_SOURCE_DIR "/legacy_cases/sliding_block/a30_p20"}, {}, {}, {}}),
                              {.folder = folder, .checkpoint_every = 7});
              return interval_after_one_step(run);
            }),
            7);
  EXPECT_EQ(in_own_context([&] {
              RecordedRun run(folder);
              return interval_after_one_step(run);
            }),
            7);
  EXPECT_EQ(in_own_context([&] {
              RecordedRun run(folder, 0.5);
              return interval_after_one_step(run);
            }),
            0.5);
}

TEST(SavedRun, a_request_is_restored_whole) {
  RunRequest saved = request();
  const RunRequest found = restored(bytes_before_steps(saved));
  EXPECT_EQ(found.program, saved.program);
  EXPECT_EQ(found.folder, saved.folder);
  EXPECT_EQ(found.working_folder, saved.working_folder);
  EXPECT_EQ(found.files, saved.files);
  EXPECT_EQ(found.profile, saved.profile);
  EXPECT_EQ(found.sets, saved.sets);
  EXPECT_EQ(found.record_every, saved.record_every);
  EXPECT_EQ(found.has_trace, saved.has_trace);
  EXPECT_EQ(found.read, saved.read);
  EXPECT_EQ(found.digests, saved.digests);
  EXPECT_EQ(found.settings, saved.settings);
  EXPECT_EQ(found.histories, saved.histories);
  EXPECT_EQ(found.contacts, saved.contacts);
  EXPECT_EQ(found.field, saved.field);
  EXPECT_EQ(found.unit, saved.unit);
  EXPECT_EQ(found.join, saved.join);
  EXPECT_EQ(found.frames, saved.frames);
  EXPECT_EQ(found.has_pictures, saved.has_pictures);
  EXPECT_EQ(found.has_page, saved.has_page);
  EXPECT_EQ(found.checkpoint_every, saved.checkpoint_every);
}

TEST(SavedRun, lists_may_be_empty_and_texts_may_hold_anything) {
  RunRequest saved = request();
  saved.files.clear();
  saved.sets = {"", "a\nb", "ünï = \"\\\""};
  const RunRequest found = restored(bytes_before_steps(saved));
  EXPECT_TRUE(found.files.empty());
  EXPECT_EQ(found.sets, saved.sets);
}

TEST(SavedRun, a_run_of_another_build_is_refused) {
  RunRequest saved = request();
  saved.program = "0.0.1, build of last year";
  const std::string bytes = bytes_before_steps(saved);
  const std::string said = complaint<InputError>([&] { restored(bytes); });
  EXPECT_TRUE(contains(said, saved.program)) << said;
  EXPECT_TRUE(contains(said, this_program())) << said;
}

TEST(SavedRun, before_its_steps_a_run_has_none_to_go_on_from) {
  RunRequest saved = request();
  EXPECT_FALSE(holds_steps(archive_of_checkpoint("a.h5", bytes_before_steps(saved))));
  Archive with_steps;
  int steps = 3;
  with_steps.group("stepper", [&] { with_steps.value("step", steps); });
  EXPECT_TRUE(holds_steps(with_steps));
}

TEST(SavedRun, a_checkpoint_is_read_from_its_file_or_said_to_be_missing) {
  const std::string folder = fresh_folder("saved_run");
  const std::filesystem::path file = checkpoint_in(folder);
  EXPECT_TRUE(contains(complaint<UsageError>([&] { read_checkpoint(file); }), file.string()));
  RunRequest saved = request();
  write_text(file, bytes_before_steps(saved));
  Archive archive = read_checkpoint(file);
  RunRequest found;
  archive.group("request", [&] { describe(archive, found); });
  EXPECT_EQ(found.folder, saved.folder);
  write_text(file, "no checkpoint");
  EXPECT_TRUE(contains(complaint<InputError>([&] { read_checkpoint(file); }), file.string()));
  std::filesystem::remove(file);
  write_text(folder + "/run.json", "{}");
  EXPECT_TRUE(contains(complaint<UsageError>([&] { read_checkpoint(file); }), "has finished"));
}

TEST(SavedRun, files_that_changed_are_refused_by_name) {
  const RunRequest saved = request();
  EXPECT_NO_THROW(require_same("c.h5", saved, saved));
  RunRequest now = saved;
  now.digests[1] = "44";
  const std::string said = complaint<InputError>([&] { require_same("c.h5", saved, now); });
  for (const char* part : {"slope.ana", "22", "44"}) EXPECT_TRUE(contains(said, part)) << said;
  now = saved;
  now.read.push_back("more.csv");
  now.digests.push_back("55");
  EXPECT_TRUE(contains(complaint<InputError>([&] { require_same("c.h5", saved, now); }), "c.h5"));
  RunRequest without = saved;
  without.digests.pop_back();
  EXPECT_NE(complaint<InputError>([&] { require_same("c.h5", without, saved); }), "");
}

TEST(SavedRun, settings_that_changed_are_refused_by_name) {
  const RunRequest saved = request();
  RunRequest now = saved;
  now.settings[1] = "b=3";
  const std::string said = complaint<InputError>([&] { require_same("c.h5", saved, now); });
  EXPECT_TRUE(contains(said, "b=2") && contains(said, "b=3")) << said;
  now.settings = {"a=1"};
  EXPECT_TRUE(contains(complaint<InputError>([&] { require_same("c.h5", saved, now); }), "b=2"));
  now.settings = {"a=1", "b=2", "c=3"};
  EXPECT_TRUE(contains(complaint<InputError>([&] { require_same("c.h5", saved, now); }), "c=3"));
}

// A folder may be moved; a copy of a run that is still in its place may not continue beside it.
TEST(SavedRun, a_copy_of_a_folder_is_refused_while_its_run_stands) {
  const std::string own = fresh_folder("saved_run_own"), copy = fresh_folder("saved_run_copy");
  RunRequest saved = request();
  saved.folder = own;
  write_text(checkpoint_in(own), "checkpoint");
  write_text(checkpoint_in(copy), "checkpoint");
  EXPECT_NO_THROW(require_own(checkpoint_in(own), saved));
  const std::string said = complaint<InputError>([&] { require_own(checkpoint_in(copy), saved); });
  EXPECT_TRUE(contains(said, own) && contains(said, copy)) << said;
  std::filesystem::remove(checkpoint_in(own));
  EXPECT_NO_THROW(require_own(checkpoint_in(copy), saved)) << "moved";
  write_text(own + "/run.json", "{}");
  EXPECT_NE(complaint<InputError>([&] { require_own(checkpoint_in(copy), saved); }), "") << "it is over there";
}

TEST(SavedRun, the_clock_of_checkpoints_is_due_after_its_interval) {
  EXPECT_FALSE(CheckpointClock(0).is_due()) << "only if the run is stopped";
  CheckpointClock often(1e-3), seldom(1000);
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_TRUE(often.is_due());
  EXPECT_FALSE(seldom.is_due());
  CheckpointClock later(0.5);
  later.written();
  EXPECT_FALSE(later.is_due());
}

}  // namespace keyblock::saved_run_test
