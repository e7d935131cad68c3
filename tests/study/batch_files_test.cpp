// Kinds of files by their content, the files that are read, and the counts by which they fit.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/batch/batch_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "formats/registry.hpp"
#include "study/batch/batch_journal.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"
#include "tests/support/two_triangles.hpp"

namespace keyblock::study::batch_files_test {

namespace fs = std::filesystem;

TEST(BatchFiles, all_but_hidden_ones_and_those_of_the_results_are_found_in_order) {
  const fs::path root = support::fresh_folder("batch_files");
  for (const char* folder : {"b", "out/jobs", ".git", "old/jobs", "mine", "fos"}) fs::create_directories(root / folder);
  for (const char* file : {"z", "b/a", "out/jobs/x", ".git/config", ".hidden", "old/jobs/y"})
    support::write_text(root / file, "");
  support::write_text(root / "old/journal.jsonl", journal_head("check"));
  support::write_text(root / "mine/run.json", "{\n \"program\": \"keyblock\",\n}");
  support::write_text(root / "fos/fos.json", "{\n \"program\": \"keyblock\",\n}");
  support::write_text(root / "b/run.json", "{\"keyblock\": 2}");
  fs::create_directory_symlink(root, root / "b" / "round");
  fs::create_symlink(root / "gone", root / "b" / "dead");
  fs::create_symlink(root / "z", root / "b" / "same");
  const FoundFiles found = files_below(root, root / "out");
  EXPECT_EQ(found.files, (std::vector<std::string>{"b/a", "b/run.json", "b/same", "z"}));
  EXPECT_EQ(sentence_of(found.passed_over),
            "1 × dead link (b/dead), 2 × hidden (the first .git), 1 × link to a folder (b/round), "
            "2 × results of a run (the first fos), 1 × results of another batch (old)");
  EXPECT_EQ(sentence_of({}), "");
  EXPECT_THROW(files_below(root / "z", {}), InputError);
}

TEST(BatchFiles, content_decides_what_a_file_is) {
  const std::string folder = KEYBLOCK_SOURCE_DIR "/tests/malformed/";
  const auto role_of = [&](const std::string& name) { return look_at(formats::load(folder + name), name).role; };
  EXPECT_EQ(role_of("00_control_orig.geo"), FileRole::geometry);
  EXPECT_EQ(role_of("00_control_xml.geo"), FileRole::geometry);
  EXPECT_EQ(role_of("00_control_orig.ana"), FileRole::analysis);
  EXPECT_EQ(role_of("00_control_xml.ana"), FileRole::analysis);
  EXPECT_EQ(role_of("05_empty_geo.geo"), FileRole::unreadable);
  EXPECT_EQ(role_of("expected.csv"), FileRole::side_file);
  EXPECT_EQ(look_at({"f", "%PDF-1.4\n1 2 3 4 5 6 7 8 9 10 11 12\n"}, "paper.pdf").role, FileRole::foreign);
  EXPECT_EQ(look_at({"f", "0.005 3\n.1\n-.2\n.3\n"}, "quake.geo").role, FileRole::side_file);
}

TEST(BatchFiles, a_name_counts_only_where_no_format_fits) {
  EXPECT_EQ(look_at({"f", "# Notes\n"}, "README.md").role, FileRole::foreign);
  EXPECT_EQ(look_at({"f", "block 0 0 0 1 1 1 1 0\njset 45 0 9 0 0 0 1 0\n"}, "slope.dat").role, FileRole::foreign);
  EXPECT_EQ(look_at({"f", "{\"about\": \"a slope\"}"}, "case.json").role, FileRole::foreign);
  EXPECT_EQ(look_at({"f", "# Notes\n"}, "slope.geo").role, FileRole::unreadable);
  EXPECT_EQ(look_at({"f", support::kTwoTrianglesFile}, "cover.txt").role, FileRole::geometry);
}

TEST(BatchFiles, a_garbled_case_is_not_taken_for_another_file) {
  EXPECT_EQ(look_at({"f", "12\n3O 0 0 0 0\n1 2 3 4 1\n"}, "case.txt").role, FileRole::unreadable);
  EXPECT_EQ(look_at({"f", "Slope 3 was cut on 12 May with 30 joints in 2 sets."}, "notes.txt").role, FileRole::foreign);
  EXPECT_EQ(look_at({"f", "{\"kyblock\": 1, \"drawing\": {\"boundary_count\": 0}}"}, "case.json").role,
            FileRole::unreadable);
}

TEST(BatchFiles, names_that_are_no_utf_8_are_escaped_and_found_again) {
  const fs::path root = support::fresh_folder("batch_escapes");
  const std::vector<std::string> raw{"50%", "50%25", "B\xF6schung", "B\xC3\xB6schung", "\xED\xA0\x80", "\xC0\xAF"};
  for (const std::string& name : raw) support::write_text(root / name, name);
  const std::vector<std::string> names = files_below(root, {}).files;
  EXPECT_EQ(names,
            (std::vector<std::string>{"%C0%AF", "%ED%A0%80", "50%25", "50%2525", "B%F6schung", "B\xC3\xB6schung"}));
  std::vector<std::string> found;
  for (const std::string& name : names) found.push_back(support::read_text(place_of(root, name)));
  EXPECT_TRUE(std::ranges::is_permutation(found, raw));
}

TEST(BatchFiles, counts_of_a_cover_are_those_its_analysis_must_have) {
  const BatchFile file = look_at({"f", support::kTwoTrianglesFile}, "cv");
  EXPECT_EQ(file.counts, (FitCounts{true, 1, 2, 1}));
}

}  // namespace keyblock::study::batch_files_test
