// Every sample of Shi's programs that may be used locally is recognised, and read if its format is.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "formats/berkeley/ddaml.hpp"
#include "formats/case.hpp"
#include "formats/shi/dda_analysis.hpp"
#include "formats/shi/dda_geometry.hpp"
#include "formats/shi/nmm_analysis.hpp"
#include "formats/shi/nmm_cover.hpp"
#include "formats/text/split.hpp"
#include "formats/text/tokens.hpp"
#include "geometry/polygon.hpp"
#include "tests/formats/reading.hpp"
#include "tests/support/content_text.hpp"
#include "tests/support/shared_folder.hpp"

namespace keyblock::formats::samples_test {
namespace {

class Samples : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder_))
      GTEST_SKIP() << "no samples at " << folder_ << "; name their folder in KEYBLOCK_SHARED";
  }

  Source sample(const std::string& name) const { return load((folder_ / name).string()); }

  const std::filesystem::path folder_ = shared_folder() / "legacy_samples";
};

std::vector<double> numbers_of(const std::string& text) {
  const Source source{"f", text};
  const Numbers numbers = tokenise(source).numbers;
  return {numbers.begin(), numbers.end()};
}

/// Words without a point: counts, indices and materials. Reals are written in their shortest form instead.
bool whole_words_are_kept(const std::string& original, const std::string& written) {
  const Source first{"original", original}, second{"written", written};
  const Tokens a = tokenise(first), b = tokenise(second);
  for (std::size_t i = 0; i < a.numbers.size() && i < b.numbers.size(); ++i) {
    const bool is_integer = a.word(i).find_first_not_of("0123456789") == std::string_view::npos;
    if (is_integer && a.word(i) != b.word(i)) return false;
  }
  return a.numbers.size() == b.numbers.size();
}

std::size_t last_slot(const SlotRange& range) {
  return static_cast<std::size_t>(range.first + range.size);
}

}  // namespace

TEST_F(Samples, circleslope_is_read_and_written_back_number_by_number) {
  const Source geometry = sample("ntdda/circleslope.geo");
  const Reading drawing = read(geometry);
  EXPECT_EQ(drawing.warnings, Warnings{});
  EXPECT_EQ(drawing.content.drawing->joints.size(), 30u);
  EXPECT_EQ(drawing.content.drawing->fixed_lines.size(), 3u);
  EXPECT_EQ(numbers_of(kDdaGeometry.write(drawing.content)), numbers_of(geometry.text));
  EXPECT_TRUE(whole_words_are_kept(geometry.text, kDdaGeometry.write(drawing.content)));
  const Source analysis = sample("ntdda/circleslope.ana");
  const Reading controls = read(analysis);
  EXPECT_EQ(controls.content.analysis->joint_materials.size(), 3u);
  EXPECT_EQ(numbers_of(kDdaAnalysisBerkeley.write(controls.content)), numbers_of(analysis.text));
}

TEST_F(Samples, every_ddaml_sample_comes_back_from_its_text) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / "ntdda")) {
    if (!entry.is_regular_file() || entry.path().stem() == "circleslope") continue;
    const Content content = read(load(entry.path())).content;
    const Content again = read({"f", kDdaml.write(content)}).content;
    EXPECT_EQ(keyblock::support::content_text(again), keyblock::support::content_text(content)) << entry.path();
  }
}

TEST_F(Samples, pushblock_pairs_and_warns_of_its_missing_gravity_only) {
  const std::string folder = (folder_ / "ntdda/loadpoint/pushblock").string();
  const Case loaded = load_case({folder + ".geo", folder + ".ana"});
  EXPECT_EQ(names(loaded.warnings), std::vector<std::string>{"default_gravaccel"});
  EXPECT_EQ(loaded.problem.analysis->point_loads.at(0).values, (std::vector<Point>{{5000, 500}, {5000, 500}}));
}

TEST_F(Samples, fixed_line_cases_hold_one_line_each) {
  for (int i = 1; i <= 8; ++i) {
    const Reading reading = read(sample("ntdda/fixedlines/case" + std::to_string(i) + ".geo"));
    EXPECT_EQ(reading.warnings, Warnings{});
    EXPECT_EQ(reading.content.drawing->fixed_lines.size(), 1u);
  }
}

TEST_F(Samples, every_nmm_file_is_recognised_for_what_it_is) {
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "pythonwithnmm")) {
    const std::string name = entry.path().filename();
    const std::string expected = name.starts_with("cv") ? "nmm-cover" : "nmm-analysis";
    EXPECT_EQ(recognise(load(entry.path())).format->name, expected) << name;
  }
}

TEST_F(Samples, every_cover_is_read_to_its_last_number_and_written_back) {
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "pythonwithnmm")) {
    const std::string name = entry.path().filename();
    if (!name.starts_with("cv")) continue;
    const Source source = load(entry.path());
    const Reading reading = read(source);
    EXPECT_EQ(reading.warnings, Warnings{}) << name;
    EXPECT_EQ(numbers_of(kNmmCover.write(reading.content)), numbers_of(source.text)) << name;
    EXPECT_TRUE(whole_words_are_kept(source.text, kNmmCover.write(reading.content))) << name;
  }
}

TEST_F(Samples, elements_of_every_cover_fill_their_slots_and_their_loops) {
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "pythonwithnmm")) {
    const std::string name = entry.path().filename();
    if (!name.starts_with("cv")) continue;
    const Cover cover = *read(load(entry.path())).content.cover;
    double elements = 0, loops = 0;
    std::size_t slots = 0;
    for (const CoverElement& element : cover.elements) {
      EXPECT_GT(area(cover.polygon(element)), 0) << name;
      EXPECT_EQ(cover.vertices.at(last_slot(element.vertices)), cover.polygon(element).front()) << name;
      elements += area(cover.polygon(element));
      slots += static_cast<std::size_t>(element.vertices.size) + 1;
    }
    EXPECT_EQ(slots, cover.vertices.size()) << name;
    for (const SlotRange& loop : cover.loops) {
      EXPECT_EQ(cover.loop_vertices.at(last_slot(loop)).slot,
                cover.loop_vertices[static_cast<std::size_t>(loop.first)].slot)
          << name;
      loops += area(cover.corners(loop));
    }
    EXPECT_NEAR(loops, elements, 1e-6 * elements) << name;  // coordinates hold 6 decimals
  }
}

TEST_F(Samples, holes_of_cv15_run_clockwise) {
  const Cover cover = *read(sample("pythonwithnmm/cv15")).content.cover;
  std::vector<double> loops;
  for (const SlotRange& loop : cover.loops) loops.push_back(area(cover.corners(loop)));
  std::ranges::sort(loops);
  ASSERT_EQ(loops.size(), 5u);
  EXPECT_NEAR(loops[1], -1.641, 5e-4);  // legacy-formats 2.4
  EXPECT_NEAR(loops[2], -1.641, 5e-4);
  EXPECT_NEAR(loops[0] + loops[3], 0, 1e-9);  // a hole that the piece in it fills
}

TEST_F(Samples, every_pair_of_cover_and_analysis_is_read_to_its_last_number_and_written_back) {
  int pairs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "pythonwithnmm")) {
    const std::string name = entry.path().filename();
    if (!name.starts_with("mf")) continue;
    ++pairs;
    const auto files = read_files({entry.path(), folder_ / "pythonwithnmm" / ("cv" + name.substr(2))});
    ASSERT_TRUE(files[0].reading && files[1].reading) << name;
    const Content& content = files[0].reading->content;
    EXPECT_EQ(content.analysis->dialect, AnalysisDialect::manifold) << name;
    const std::vector<std::string> expected =
        name == "mf13" ? std::vector<std::string>{"trailing_text"} : std::vector<std::string>{};
    EXPECT_EQ(names(files[0].reading->warnings), expected) << name;
    EXPECT_EQ(content.analysis->point_loads.size(), files[1].reading->content.cover->loading_points.size()) << name;
    EXPECT_EQ(numbers_of(kNmmAnalysis.write(content)), numbers_of(files[0].source.text)) << name;
  }
  EXPECT_GE(pairs, 12);
}

TEST_F(Samples, every_reference_run_is_read_without_error) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(shared_folder() / "reference_runs")) {
    const std::string extension = entry.path().extension();
    const bool is_input = extension == ".geo" || extension == ".ana";
    if (!is_input || entry.path().parent_path().filename() == "malformed") continue;
    EXPECT_EQ(error_of(load(entry.path()).text), "") << entry.path();
  }
}

}  // namespace keyblock::formats::samples_test
