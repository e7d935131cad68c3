// A run restored from its checkpoint reports the same as the undisturbed run, bit for bit; an incomplete checkpoint is
// refused.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/checkpoint.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <thread>

#include "api/case_folder.hpp"
#include "api/named_files.hpp"
#include "base/context.hpp"
#include "formats/case.hpp"
#include "result/describe.hpp"
#include "run/prepare.hpp"
#include "run/run.hpp"
#include "run/steppers.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::checkpoint_test {
namespace {

constexpr int kSteps = 24;
constexpr int kRecordEvery = 5;

struct Sample {
  const char* folder;  // below legacy_cases
  std::vector<Override> settings;
  std::vector<std::string> profiles = {"legacy", "standard"};
};

// One scene for each feature whose memory lasts from step to step.
const std::vector<Sample>& samples() {
  static const std::vector<Sample> all{
      {"circle_slope", {}, {"legacy"}},                                             // many contacts, a step by rule
      {"circle_slope", {{"linear_method", "conjugate_gradients"}}, {"legacy"}},     // iterations from a guess
      {"sliding_block_on_covers", {}, {"standard"}},                                // NMM bodies
      {"toppling_column/falls", {{"step_control", "shi"}, {"time_step", "0.01"}}},  // contact, parts of a step
      {"stack/five_blocks", {{"enforcement", "penalty"}}, {"standard"}},            // stretched springs
      {"restitution/e_050",
       {{"step_control", "error"}, {"time_step", "0.005"}},
       {"standard"}},                                                 // impact, parts by their error
      {"bolt/breaking", {{"time_step", "0.02"}}},                     // bolts, broken ones
      {"driven_point/ramp", {}},                                      // a driven point
      {"masonry_arch/quake_thin_falls", {}},                          // a settled initial state
      {"cohesive_joint/c40", {}},                                     // bonds
      {"settlement/five_tall_static", {{"enforcement", "penalty"}}},  // statics
      {"settlement/five_tall_static", {{"motion", "static"}, {"load_steps", "6"}}, {"standard"}},  // loads in parts
      {"push_block/ramp", {{"integrator", "generalized_alpha"}}},          // a load in time, kept accelerations
      {"newmark_sine/row_1", {{"body_acceleration_file", "motion.csv"}}},  // a shaken scene
  };
  return all;
}

Scene scene_of_sample(const Sample& sample, const std::string& profile) {
  const std::string path = std::string(KEYBLOCK_SOURCE_DIR) + "/legacy_cases/" + sample.folder;
  const CaseFolder folder = find_cases({path}).front();
  Problem problem = formats::load_case(folder.inputs()).problem;
  problem.analysis->step_count = kSteps;
  std::vector<Override> settings = sample.settings;
  for (auto& [name, value] : settings) value = from_folder(folder.folder, name, value);
  return prepare(with_named_files(problem, settings), profile, settings).scene;
}

/// All reports of a run.
struct Told {
  std::vector<Frame> frames;
  std::vector<HistoryRow> rows;
  std::vector<StepReport> steps;
  std::vector<LedgerRow> books;

  Observer observer() {
    return {[&](const Frame& frame) { frames.push_back(frame); },
            [&](const StepReport& report) { steps.push_back(report); },
            [&](const HistoryRow& row) { rows.push_back(row); },
            [&](const LedgerRow& row) { books.push_back(row); },
            {}};
  }

  void describe(Archive& a) {
    a.list("frames", frames, [&](Frame& frame) { keyblock::describe(a, frame); });
    a.list("rows", rows, [&](HistoryRow& row) { keyblock::describe(a, row); });
    a.list("steps", steps, [&](StepReport& report) { keyblock::describe(a, report); });
    a.list("books", books, [&](LedgerRow& row) { keyblock::describe(a, row); });
  }

  std::string bytes() {
    Archive archive;
    describe(archive);
    return checkpoint_bytes(archive);
  }
};

/// The reports until `step`, and the checkpoint there.
std::pair<Told, std::string> left_at(const Scene& scene, int step) {
  Told told;
  std::string bytes;
  Observer observer = told.observer();
  const Context own;
  observer.between_steps = [&](Stepper& stepper) {
    if (static_cast<int>(told.steps.size()) != step) return;
    own.stop();
    Archive archive;
    told.describe(archive);
    stepper.save(archive);
    bytes = checkpoint_bytes(archive);
  };
  const Under under(own);
  run(scene, kRecordEvery, observer);
  return {told, bytes};
}

Told gone_on(const Scene& scene, const std::string& bytes) {
  Archive archive = archive_of_checkpoint("checkpoint.h5", bytes);
  Told told;
  told.describe(archive);
  const std::unique_ptr<Stepper> stepper = restored_stepper(scene, archive);
  go_on(scene, *stepper, kRecordEvery, told.observer());
  return told;
}

std::string refusal(const std::string& bytes) {
  try {
    archive_of_checkpoint("a.h5", bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

Scene falling_block(double width) {
  return support::legacy_scene({{support::rectangle({0, 10}, {width, 11})}, {}, {}, {}, {}, {}},
                               support::plain_analysis(1e-3, 4));
}

}  // namespace

TEST(Checkpoint, a_run_left_at_any_step_goes_on_to_the_same_bits) {
  for (const Sample& sample : samples()) {
    for (const std::string& profile : sample.profiles) {
      const Scene scene = scene_of_sample(sample, profile);
      Told whole;
      const RunOutcome outcome = run(scene, kRecordEvery, whole.observer());
      EXPECT_GT(outcome.steps, 1) << sample.folder << " " << profile << " " << outcome.reason;
      for (const int step : {0, 5, 23}) {
        if (step >= outcome.steps) continue;
        Told resumed = gone_on(scene, left_at(scene, step).second);
        EXPECT_EQ(resumed.bytes(), whole.bytes()) << sample.folder << " " << profile << " left at step " << step;
      }
    }
  }
}

TEST(Checkpoint, a_run_may_be_left_again_and_again) {
  const Scene scene = scene_of_sample(samples()[1], "standard");
  Told whole;
  run(scene, kRecordEvery, whole.observer());
  Told told;
  std::string bytes = left_at(scene, 0).second;
  for (int step = 1; step <= kSteps; ++step) {
    Archive archive = archive_of_checkpoint("checkpoint.h5", bytes);
    told.describe(archive);
    const std::unique_ptr<Stepper> stepper = restored_stepper(scene, archive);
    Observer observer = told.observer();
    const Context own;
    observer.between_steps = [&](Stepper& now) {
      if (static_cast<int>(told.steps.size()) != step) return;
      own.stop();
      Archive next;
      told.describe(next);
      now.save(next);
      bytes = checkpoint_bytes(next);
    };
    const Under under(own);
    go_on(scene, *stepper, kRecordEvery, observer);
  }
  EXPECT_EQ(told.bytes(), whole.bytes());
}

TEST(Checkpoint, numbers_come_back_with_every_bit) {
  Archive saving;
  std::vector<double> numbers{-0.0, 5e-324, std::nextafter(1, 2), std::numeric_limits<double>::infinity(), 0.1};
  std::vector<double> nothing;
  std::string text = "Grüße";
  std::string empty;
  int least = std::numeric_limits<int>::min();
  double nan = std::nan("7");
  const auto describe = [&](Archive& archive) {
    archive.numbers("numbers", numbers);
    archive.numbers("nothing", nothing);
    archive.value("text", text);
    archive.value("empty", empty);
    archive.value("least", least);
    archive.value("nan", nan);
  };
  describe(saving);
  const std::string bytes = checkpoint_bytes(saving);
  const std::vector<double> saved = numbers;
  const auto saved_nan = std::bit_cast<std::uint64_t>(nan);
  numbers = nothing = {1, 2};
  text = empty = "other";
  least = 0;
  nan = 0;
  Archive restoring = archive_of_checkpoint("a.h5", bytes);
  describe(restoring);
  EXPECT_EQ(numbers, saved);
  EXPECT_TRUE(std::signbit(numbers[0]));
  EXPECT_TRUE(nothing.empty());
  EXPECT_EQ(text, "Grüße");
  EXPECT_TRUE(empty.empty());
  EXPECT_EQ(least, std::numeric_limits<int>::min());
  EXPECT_EQ(std::bit_cast<std::uint64_t>(nan), saved_nan);
}

TEST(Checkpoint, cut_off_changed_foreign_and_later_files_are_refused) {
  const std::string whole = left_at(falling_block(1), 2).second;
  EXPECT_EQ(refusal(whole), "");
  for (const std::size_t size :
       {std::size_t{40}, std::size_t{511}, std::size_t{512}, whole.size() / 2, whole.size() - 1})
    EXPECT_NE(refusal(whole.substr(0, size)).find("a.h5: error: expected the bytes that were saved, found others"),
              std::string::npos)
        << size;
  for (std::size_t at = 40; at < whole.size(); at += 997) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 4);
    EXPECT_NE(refusal(changed), "") << at;
  }
  EXPECT_NE(refusal("").find("expected a checkpoint of keyblock, found something else"), std::string::npos);
  std::string later = whole;
  later.replace(later.find("layout 8"), 8, "layout 9");
  EXPECT_EQ(refusal(later), "a.h5: error: expected a checkpoint of layout 8, found layout 9");
}

TEST(Checkpoint, a_state_of_another_model_is_refused_before_room_is_made_for_it) {
  const std::string bytes = left_at(falling_block(1), 2).second;
  Blocks two{{support::rectangle({0, 10}, {1, 11}), support::rectangle({2, 10}, {3, 11})}, {}, {}, {}, {}, {}};
  const Scene other = support::legacy_scene(two, support::plain_analysis(1e-3, 4));
  try {
    gone_on(other, bytes);
    FAIL() << "taken";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "checkpoint.h5: error: expected 8 as in the model, found 4 (vertices: count)");
  }
}

TEST(Checkpoint, threads_save_and_restore_at_once) {
  std::vector<double> numbers(1000, 0.5);
  Archive saving;
  for (int i = 0; i < 20; ++i) saving.numbers(fmt::format("n{}", i).c_str(), numbers);
  const std::string bytes = checkpoint_bytes(saving);
  const std::string alone = checkpoint_bytes(archive_of_checkpoint("a.h5", bytes));
  std::atomic<int> same{0};
  std::vector<std::jthread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int j = 0; j < 10; ++j)
        if (checkpoint_bytes(archive_of_checkpoint("a.h5", bytes)) == alone) ++same;
    });
  threads.clear();
  EXPECT_EQ(same, 40);
}

TEST(Checkpoint, indices_and_counts_out_of_bounds_are_refused) {
  Archive saving;
  VertexIndex vertex{7};
  std::size_t many = std::size_t{1} << 60;
  saving.index("vertex", vertex, {8});
  saving.group("rows", [&] { saving.value("count", many); });
  const std::string bytes = checkpoint_bytes(saving);
  Archive restoring = archive_of_checkpoint("a.h5", bytes);
  std::vector<double> rows;
  EXPECT_THROW(restoring.index("vertex", vertex, {7}), InputError);
  EXPECT_THROW(restoring.numbers("rows", rows), InputError);
  EXPECT_THROW(restoring.value("absent", many), InputError);
}

}  // namespace keyblock::checkpoint_test
