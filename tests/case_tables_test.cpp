// Every case has its input, a README with four headings, and a table whose values have tolerance, reason and source.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "formats/text/csv.hpp"

namespace keyblock::formats::case_tables_test {
namespace {

namespace fs = std::filesystem;

const fs::path kCases = fs::path(KEYBLOCK_SOURCE_DIR) / "legacy_cases";

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<fs::path> tables() {
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kCases))
    if (entry.path().filename() == "expected.csv") found.push_back(entry.path());
  std::ranges::sort(found);
  return found;
}

CsvTable read_table(const fs::path& file) {
  return read_csv({file.string(), text_of(file)});
}

}  // namespace

TEST(CaseTables, there_are_twenty_one_sliding_blocks_and_every_case_has_one_input_pair) {
  std::size_t slides = 0;
  for (const fs::path& table : tables())
    if (table.parent_path().parent_path().filename() == "sliding_block") ++slides;
  EXPECT_EQ(slides, 21U);
  for (const fs::path& table : tables()) {
    const fs::path folder = table.parent_path();
    const fs::path input = folder / folder.filename();
    if (fs::exists(input.string() + ".json")) continue;  // one file holds both
    EXPECT_TRUE(fs::exists(input.string() + ".geo") || fs::exists(input.string() + ".blk")) << folder;
    EXPECT_TRUE(fs::exists(input.string() + ".ana") || fs::exists(input.string() + ".df")) << folder;
  }
}

TEST(CaseTables, every_value_has_tolerance_reason_and_source) {
  const std::vector<std::string> plain{"quantity", "block", "time", "value", "tolerance", "tolerance_reason", "source"};
  std::vector<std::string> judged = plain;
  judged.push_back("judged");
  std::vector<std::string> listed = judged;
  listed.push_back("listed_miss");
  for (const fs::path& file : tables()) {
    const CsvTable table = read_table(file);
    ASSERT_TRUE(table.header == plain || table.header == judged || table.header == listed) << file;
    EXPECT_FALSE(table.rows.empty()) << file;
    for (const CsvRow& row : table.rows) {
      EXPECT_GE(csv_real(table, row, csv_column(table, "time")), 0) << file << ':' << row.line;
      EXPECT_NO_THROW(csv_real(table, row, csv_column(table, "value")));
      EXPECT_GE(csv_real(table, row, csv_column(table, "tolerance")), 0) << file << ':' << row.line;
      EXPECT_FALSE(row.cells[5].empty() || row.cells[6].empty()) << file << ':' << row.line;
    }
  }
}

TEST(CaseTables, no_tolerance_is_so_wide_that_standing_still_would_pass) {
  for (const fs::path& file : tables()) {
    const CsvTable table = read_table(file);
    for (const CsvRow& row : table.rows) {
      const double value = csv_real(table, row, csv_column(table, "value"));
      if (value == 0) continue;
      // A verdict depends only on fall or slip.
      const bool is_verdict = row.cells[csv_column(table, "tolerance_reason")].starts_with("verdict: ");
      const bool is_listed = row.cells.size() > 8 && !row.cells[8].empty();  // a miss cannot pass
      const bool is_of_benchmark = row.cells[csv_column(table, "tolerance_reason")].starts_with("asked for: ");
      const double share = is_verdict || is_listed ? 1 : is_of_benchmark ? 0.25 : 0.1;
      EXPECT_LT(csv_real(table, row, csv_column(table, "tolerance")), share * std::abs(value))
          << file << ':' << row.line;
    }
  }
}

TEST(CaseTables, every_case_has_reference_model_purpose_and_results) {
  for (const fs::directory_entry& entry : fs::directory_iterator(kCases)) {
    if (!entry.is_directory()) continue;
    const std::string text = text_of(entry.path() / "README.md");
    std::size_t at = 0;
    for (const char* heading :
         {"\n## Reference solution\n", "\n## Model\n", "\n## What it verifies\n", "\n## Results\n"}) {
      at = text.find(heading, at);
      EXPECT_NE(at, std::string::npos) << entry.path() << ' ' << heading;
    }
  }
}

}  // namespace keyblock::formats::case_tables_test
