// Every sample of the old programs that may be used locally is recognised, and read where its format is.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "formats/case.hpp"
#include "formats/dda_analysis.hpp"
#include "formats/dda_geometry.hpp"
#include "formats/tokens.hpp"
#include "tests/formats/reading.hpp"
#include "tests/support/shared_folder.hpp"

namespace keyblock::formats {
namespace {

class Samples : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder_))
      GTEST_SKIP() << "no samples at " << folder_ << "; name their folder in KEYBLOCK_SHARED";
  }

  Source sample(const std::string& name) const { return load((folder_ / name).string()); }

  const std::filesystem::path folder_ = shared_folder() / "legacy_samples";
};

std::vector<double> numbers_of(const std::string& text) {
  return tokenise({"f", text}).numbers;
}

}  // namespace

TEST_F(Samples, circleslope_is_read_and_written_back_number_by_number) {
  const Source geometry = sample("ntdda/circleslope.geo");
  const Reading drawing = read(geometry);
  EXPECT_EQ(drawing.warnings, Warnings{});
  EXPECT_EQ(drawing.content.drawing->joints.size(), 30u);
  EXPECT_EQ(drawing.content.drawing->fixed_lines.size(), 3u);
  EXPECT_EQ(numbers_of(kDdaGeometry.write(drawing.content)), numbers_of(geometry.text));
  const Source analysis = sample("ntdda/circleslope.ana");
  const Reading controls = read(analysis);
  EXPECT_EQ(controls.content.analysis->joint_materials.size(), 3u);
  EXPECT_EQ(numbers_of(kDdaAnalysisBerkeley.write(controls.content)), numbers_of(analysis.text));
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

TEST_F(Samples, every_reference_run_is_read_without_error) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(shared_folder() / "reference_runs")) {
    const std::string extension = entry.path().extension();
    const bool is_input = extension == ".geo" || extension == ".ana";
    if (!is_input || entry.path().parent_path().filename() == "malformed") continue;
    EXPECT_EQ(error_of(load(entry.path()).text), "") << entry.path();
  }
}

}  // namespace keyblock::formats
