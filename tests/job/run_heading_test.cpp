// Headings of pictures, from the record of a run that is over.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/run_heading.hpp"

#include <gtest/gtest.h>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::run_heading_test {
namespace {

RunHeading heading_from(const std::string& record) {
  const std::string folder = support::fresh_folder("run_heading");
  support::write_text(folder + "/run.json", record);
  return heading_of(folder);
}

}  // namespace

TEST(RunHeading, a_title_names_case_profile_and_time) {
  EXPECT_EQ(title_of("/some/where/slope.json", "standard"), "slope, profile standard");
  EXPECT_EQ(title_of("two.parts.geo", "legacy"), "two.parts, profile legacy");
  EXPECT_EQ(title_at("slope", 1.5, {"m", "kg", "s"}), "slope, time 1.5 s");
  EXPECT_EQ(title_at("slope", 0, {}), "slope, time 0");
  EXPECT_EQ(title_at("slope", 1234567.8, {"m", "kg", "ms"}), "slope, time 1.23457e+06 ms");
}

TEST(RunHeading, a_record_gives_title_units_and_numbers_from_0) {
  const RunHeading heading = heading_from(R"({"inputs": [{"file": "a \"b\"/dam.geo"}, {"file": "x.ana"}],
    "profile": "standard", "units": {"length": "mm", "mass": "t", "time": "s", "force": "N"}, "is_of_motion": false,
    "left_out": [3, 12], "held": [1]})");
  EXPECT_EQ(heading.title, "dam, profile standard");
  EXPECT_EQ(heading.units, (Units{"mm", "t", "s"}));
  EXPECT_FALSE(heading.is_of_motion);
  EXPECT_EQ(heading.left_out, (std::vector<int>{2, 11}));
  EXPECT_EQ(heading.held, (std::vector<int>{0}));
}

TEST(RunHeading, what_a_record_lacks_is_as_without_one) {
  const RunHeading heading = heading_from("{}");
  EXPECT_TRUE(heading.title.starts_with("run_heading")) << "the folder: " << heading.title;
  EXPECT_EQ(heading.units, Units{});
  EXPECT_TRUE(heading.is_of_motion);
  EXPECT_TRUE(heading.left_out.empty());
  EXPECT_TRUE(heading.held.empty());
}

TEST(RunHeading, values_of_another_kind_count_as_none) {
  const RunHeading heading = heading_from(R"({"inputs": {"file": "a.geo"}, "profile": 7, "units": "metres",
    "is_of_motion": "yes", "left_out": "3", "held": [1.5, "2", null, 4]})");
  EXPECT_TRUE(heading.title.starts_with("run_heading"));
  EXPECT_EQ(heading.units, Units{});
  EXPECT_TRUE(heading.is_of_motion);
  EXPECT_TRUE(heading.left_out.empty());
  EXPECT_EQ(heading.held, (std::vector<int>{3}));
}

TEST(RunHeading, a_run_without_a_record_is_named_after_its_folder) {
  const std::string folder = support::fresh_folder("run_heading_killed");
  const std::string name = std::filesystem::path(folder).filename().string();
  EXPECT_EQ(heading_of(folder).title, name);
  EXPECT_EQ(heading_of(folder + "/").title, name);
  EXPECT_EQ(heading_of(folder + "/.").title, name);
}

TEST(RunHeading, a_file_that_is_no_record_is_refused) {
  for (const char* text : {"", "{", "[1, 2]", "\"text\"", "7", "time,step\n1,2\n"})
    EXPECT_THROW(heading_from(text), InputError) << text;
}

}  // namespace keyblock::run_heading_test
