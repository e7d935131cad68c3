// Cases are the folders with expected values or a trace, at any depth.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "api/case_folder.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::case_folder_test {

namespace fs = std::filesystem;
using support::fresh_folder;
using support::write_text;

TEST(CaseFolders, are_found_below_a_path_in_order_of_their_names) {
  const fs::path root = fresh_folder("case_folders");
  for (const char* name : {"b/two", "a", "b/one", "empty"}) fs::create_directories(root / name);
  write_text(root / "a" / "expected.csv", "");
  write_text(root / "b" / "two" / "expected.csv", "");
  write_text(root / "b" / "one" / "steps.csv", "");
  write_text(root / "b" / "one" / "blocks.csv", "");
  write_text(root / "empty" / "steps.csv", "");  // a trace needs blocks.csv too
  const std::vector<CaseFolder> cases = find_cases({root.string() + "/"});
  ASSERT_EQ(cases.size(), 3U);
  EXPECT_EQ(cases[0].name, "a");
  EXPECT_EQ(cases[1].name, "b/one");
  EXPECT_TRUE(cases[1].has_trace);
  EXPECT_FALSE(cases[1].has_expected);
  EXPECT_EQ(cases[2].name, "b/two");
  EXPECT_EQ(cases[2].inputs().front(), (root / "b" / "two" / "two.geo").string());
}

TEST(CaseFolders, the_case_at_a_path_is_taken_whatever_results_lie_in_it) {
  const fs::path root = fresh_folder("case_with_results");
  for (const char* name : {"z/a", "y"}) fs::create_directories(root / name);
  for (const char* name : {"z/expected.csv", "z/a/steps.csv", "z/a/blocks.csv", "y/expected.csv"})
    write_text(root / name, "");
  EXPECT_EQ(the_case_in((root / "z").string()).folder.filename(), "z");
  EXPECT_EQ(the_case_in((root / "z" / "").string()).folder.filename(), "z");
  EXPECT_THROW(the_case_in(root.string()), InputError) << "several";
  fs::remove_all(root / "z");
  EXPECT_EQ(the_case_in(root.string()).folder.filename(), "y") << "the one below";
}

TEST(CaseFolders, results_of_a_run_with_a_trace_are_no_case) {
  const fs::path root = fresh_folder("results_in_case");
  fs::create_directories(root / "out");
  write_text(root / "expected.csv", "");
  for (const char* name : {"out/steps.csv", "out/blocks.csv", "out/run.json"}) write_text(root / name, "");
  EXPECT_EQ(find_cases({root.string()}).size(), 1U);
}

TEST(CaseFolders, a_link_that_leads_up_is_not_followed) {
  const fs::path root = fresh_folder("case_with_link");
  fs::create_directories(root / "a");
  write_text(root / "a" / "expected.csv", "");
  fs::create_directory_symlink(root, root / "a" / "up");
  EXPECT_EQ(find_cases({root.string()}).size(), 1U);
}

TEST(CaseFolders, a_path_without_any_is_refused) {
  EXPECT_THROW(find_cases({fresh_folder("no_cases")}), InputError);
  EXPECT_THROW(find_cases({fresh_folder("no_cases") + "/none"}), InputError);
}

}  // namespace keyblock::case_folder_test
