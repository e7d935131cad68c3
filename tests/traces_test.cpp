// Profile `legacy` follows every trace of the Berkeley program from its input files.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "formats/case.hpp"
#include "formats/registry.hpp"
#include "formats/text/csv.hpp"
#include "run/prepare.hpp"
#include "run/run.hpp"
#include "study/cases/trace.hpp"
#include "tests/support/program.hpp"
#include "tests/support/shared_folder.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::study::traces_test {
namespace {

const std::string kTraces = KEYBLOCK_SOURCE_DIR "/legacy_cases/reference_traces";

void expect_followed(const CaseFolder& folder) {
  const TraceDifference difference = follow_trace(folder);
  EXPECT_TRUE(difference.holds()) << fmt::format(
      "{}: {} of {} steps, polygon {:.1e}, position {:.1e}, rotation {:.1e}, stress {:.1e}\n{}", difference.name,
      difference.steps, difference.steps_in_trace, difference.polygon, difference.position, difference.rotation,
      difference.stress, fmt::join(difference.unequal, "\n"));
}

/// A scene of reference_runs/scaling beside the output of the Berkeley program, kept in findings/traces: every block
/// and step.
struct Scaling {
  std::string name;      // of the drawing
  std::string analysis;  // without its ending
  int steps = 0;
};

void expect_followed(const Scaling& scene, const std::filesystem::path& shared) {
  const std::filesystem::path scaling = shared / "reference_runs" / "scaling";
  const auto table = [&](const char* what) {
    return formats::read_csv(
        formats::load((shared / "findings" / "traces" / (scene.name + "_" + what + ".csv")).string()));
  };
  const formats::CsvTable blocks = table("blocks");  // step, time, block, cx, cy, area
  const formats::CsvTable steps = table("steps");    // step, time, dt, passes_total, contacts, penalty
  const formats::Case loaded =
      formats::load_case({(scaling / (scene.name + ".geo")).string(), (scaling / (scene.analysis + ".ana")).string()});
  std::vector<Frame> frames;
  int passes = 0;
  Observer observer;
  observer.on_frame = [&](const Frame& frame) { frames.push_back(frame); };
  observer.on_step = [&](const StepReport& step) {
    passes += step.passes;
    const formats::CsvRow& row = steps.rows.at(static_cast<std::size_t>(step.step));
    EXPECT_EQ(passes, formats::csv_real(steps, row, 3)) << scene.name << " step " << step.step;
    EXPECT_EQ(step.contacts, formats::csv_real(steps, row, 4)) << scene.name << " step " << step.step;
  };
  run(prepare(loaded.problem, "legacy", {{"steps", std::to_string(scene.steps)}}).scene, 1, observer);
  ASSERT_EQ(blocks.rows.size(), frames.size() * frames.front().elements.size()) << scene.name;
  double apart = 0;
  for (const formats::CsvRow& row : blocks.rows) {
    const auto step = static_cast<std::size_t>(formats::csv_real(blocks, row, 0));
    const auto block = static_cast<std::size_t>(formats::csv_real(blocks, row, 2)) - 1;
    const Point then{formats::csv_real(blocks, row, 3), formats::csv_real(blocks, row, 4)};
    apart = std::max(apart, distance(frames.at(step).elements.at(block).centroid, then));
  }
  EXPECT_LT(apart, 1e-9) << scene.name;  // of coordinates of 10, printed with 10 to 12 digits
}

}  // namespace

// Where four blocks meet, angles that are equal up to rounding choose the entrance lines: every crossing of joints.
TEST(Traces, legacy_profile_follows_a_slope_and_a_grid_block_by_block) {
  if (!std::filesystem::exists(shared_folder() / "findings" / "traces"))
    GTEST_SKIP() << "the traces of jointed slopes lie only in ../shared";
  expect_followed(Scaling{"slope10", "slope_N10", 40}, shared_folder());
  expect_followed(Scaling{"grid10", "scale_N10_maxd_0.01", 40}, shared_folder());
  expect_followed(Scaling{"slope20", "slope_N20", 10},
                  shared_folder());  // the Berkeley program loses one of 516 blocks
}

// From 300 blocks on systems are solved by iterations, whose errors must not reach contact decisions.
TEST(Traces, a_grid_of_401_blocks_moves_alike_by_iterations_and_by_the_factor) {
  const std::filesystem::path scaling = shared_folder() / "reference_runs" / "scaling";
  if (!std::filesystem::exists(scaling)) GTEST_SKIP() << "grids lie only in ../shared";
  const formats::Case loaded =
      formats::load_case({(scaling / "grid20.geo").string(), (scaling / "scale_N20_maxd_0.01.ana").string()});
  std::vector<Frame> ends;
  std::vector<int> passes;
  for (const char* method : {"automatic", "factor"}) {
    passes.push_back(0);
    Observer observer;
    observer.on_step = [&](const StepReport& step) { passes.back() += step.passes; };
    observer.on_frame = [&](const Frame& frame) {
      if (frame.step == 40) ends.push_back(frame);
    };
    run(prepare(loaded.problem, "legacy", {{"steps", "40"}, {"linear_method", method}}).scene, 40, observer);
  }
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_EQ(passes.front(), passes.back());
  for (std::size_t i = 0; i < ends[0].elements.size(); ++i)
    EXPECT_LT(distance(ends[0].elements[i].centroid, ends[1].elements[i].centroid), 1e-10) << "block " << i + 1;
}

TEST(Traces, legacy_profile_follows_all_sixteen_traces_in_the_repository) {
  const std::vector<CaseFolder> folders = find_cases({kTraces});
  EXPECT_EQ(folders.size(), 16U);
  for (const CaseFolder& folder : folders) expect_followed(folder);
}

TEST(Traces, legacy_profile_follows_the_push_block_trace) {
  const std::filesystem::path folder = shared_folder() / "reference_runs" / "pushblock";
  if (!std::filesystem::exists(folder))
    GTEST_SKIP() << "the push-block trace has no licence and lies only in ../shared";
  for (const CaseFolder& found : find_cases({folder.string()})) expect_followed(found);
}

// Not independent: the automatic penalty of native files, the mean area and the stiffness of the step rule were
// inferred from these very figures. The Berkeley program's own example, native files with automatic step and penalty.
// reference_runs/examples.csv holds its output: iterations in all, most contacts, largest penetration, longest step,
// with six digits. Round-off of its step formula keeps the end time to six digits.
TEST(Traces, the_circle_slope_example_comes_back_with_automatic_step_and_penalty) {
  const std::filesystem::path sample = shared_folder() / "legacy_samples" / "ntdda" / "circleslope";
  if (!std::filesystem::exists(sample.string() + ".geo"))
    GTEST_SKIP() << "the sample has no licence and lies only in ../shared";
  const formats::Case loaded = formats::load_case({sample.string() + ".geo", sample.string() + ".ana"});
  int passes = 0;
  int contacts = 0;
  double penetration = 0;
  double longest = 0;
  Observer observer;
  observer.on_step = [&](const StepReport& step) {
    passes += step.passes;
    contacts = std::max(contacts, step.contacts);
    penetration = std::max(penetration, step.greatest_penetration);
    longest = std::max(longest, step.dt);
  };
  const RunOutcome outcome = run(prepare(loaded.problem, "legacy", {}).scene, 1, observer);
  EXPECT_EQ(outcome.steps, 20);
  EXPECT_EQ(passes, 69);
  EXPECT_EQ(contacts, 59);
  EXPECT_NEAR(penetration, 0.000584652, 5e-10);
  EXPECT_NEAR(longest, 0.0449237, 5e-8);
  EXPECT_NEAR(outcome.time, 0.393914414, 1e-6);
}

// The measure itself: a run with another penalty does not follow, and the message says so.
TEST(Traces, a_run_that_differs_is_found_to_differ) {
  const std::filesystem::path folder = support::fresh_folder("trace") + "/incline_a30_p20_dt1ms";
  std::filesystem::copy(kTraces + "/incline_a30_p20_dt1ms", folder);
  std::string analysis = support::read_text(folder / "incline_a30_p20_dt1ms.ana");
  const std::string given = "<Friction> 20 </Friction>";
  analysis.replace(analysis.find(given), given.size(), "<Friction> 20.001 </Friction>");
  support::write_text(folder / "incline_a30_p20_dt1ms.ana", analysis);
  const TraceDifference difference = follow_trace(find_cases({folder.string()}).front());
  EXPECT_FALSE(difference.holds());
  EXPECT_GT(difference.position, kTraceTolerance);
}

}  // namespace keyblock::study::traces_test
