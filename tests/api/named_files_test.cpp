// The table that `body_acceleration_file` names reaches the settings of the run; a missing one is an error of the
// input.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "api/named_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "tests/support/scenes.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::named_files_test {
namespace {

Problem one_block() {
  return {Blocks{{support::rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}}, support::plain_analysis(1e-3, 1)};
}

}  // namespace

TEST(NamedFiles, the_table_is_read_from_the_folder_and_becomes_the_curve_of_the_run) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "named_files";
  std::filesystem::create_directories(folder);
  support::write_text(folder / "shake.csv", "time,ax,ay\n0,0,0\n2,4,0\n");
  const std::vector<Override> overrides{
      {"body_acceleration_file", from_folder(folder, "body_acceleration_file", "shake.csv")}};
  for (const char* profile : {"legacy", "standard"}) {
    const Prepared prepared = prepare(with_named_files(one_block(), overrides), profile, overrides);
    EXPECT_EQ(prepared.scene.settings.body_acceleration.curve.at(1), (Point{2, 0}));
    EXPECT_TRUE(prepared.requirements.has(TermKind::body_acceleration));
  }
}

TEST(NamedFiles, a_case_file_names_the_table_from_its_own_folder_and_the_command_line_overrules_it) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "named_by_case";
  std::filesystem::create_directories(folder);
  support::write_text(folder / "shake.csv", "time,ax,ay\n0,0,0\n2,4,0\n");
  support::write_text(folder / "other.csv", "time,ax,ay\n0,0,0\n2,8,0\n");
  Problem problem = one_block();
  problem.choices.settings = {{"body_acceleration_file", "shake.csv"}};
  problem.choices.setting_places = {{(folder / "case.json").string(), 1, 1}};
  const Problem read = with_named_files(problem, {});
  const Prepared prepared = prepare(read, "standard", {});
  EXPECT_EQ(prepared.scene.settings.body_acceleration.curve.at(1), (Point{2, 0}));
  EXPECT_EQ(prepared.scene.settings.body_acceleration.file, (folder / "shake.csv").string());
  const std::vector<Override> overrides{{"body_acceleration_file", (folder / "other.csv").string()}};
  const Prepared overruled = prepare(with_named_files(problem, overrides), "standard", overrides);
  EXPECT_EQ(overruled.scene.settings.body_acceleration.curve.at(1), (Point{4, 0}));
  problem.choices.settings[0].second = "no_such.csv";
  EXPECT_THROW(with_named_files(problem, {}), InputError);
}

TEST(NamedFiles, a_missing_file_is_an_input_error_and_a_name_that_was_not_read_is_refused) {
  const std::vector<Override> overrides{{"body_acceleration_file", "no_such.csv"}};
  EXPECT_THROW(with_named_files(one_block(), overrides), InputError);
  EXPECT_THROW(prepare(one_block(), "legacy", overrides), std::invalid_argument);
}

}  // namespace keyblock::named_files_test
