// Lines of the journal come back unchanged, and a torn line does not count.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/batch/batch_journal.hpp"

#include <gtest/gtest.h>

#include "formats/text/csv.hpp"
#include "study/batch/batch_catalogue.hpp"

namespace keyblock::study::batch_journal_test {
namespace {

report::CatalogueRow some_row(const std::string& name) {
  report::CatalogueRow row;
  row.name = name;
  row.files = {{name, "dda-geometry", "00ff"}, {"x.ana", "", ""}};
  row.paired_by = "the same name";
  row.blocks = 3;
  row.steps = 100;
  row.outcome = "failed";
  row.warnings = 2;
  row.message = "found \"a, b\"";
  row.answers = {{"legacy", "finished", 100, 0.5, "measured point 1", 0.1, -0.2, std::nullopt}};
  row.difference = 1e-3;
  row.expected = "legacy: hold";
  row.outputs = {"jobs/a/legacy"};
  row.thumbnail = "<svg/>";
  return row;
}

}  // namespace

TEST(BatchJournal, a_row_comes_back_with_every_field) {
  const report::CatalogueRow row = some_row("a.geo");
  const Journal journal = read_journal(journal_head("check") + journal_line(row, 0.25));
  EXPECT_EQ(journal.task, "check");
  const auto* found = journal.find("a.geo", row.files);
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(json_of(*found), json_of(row));
}

TEST(BatchJournal, a_row_done_on_other_bytes_is_not_found) {
  const Journal journal = read_journal(journal_head("check") + journal_line(some_row("a.geo"), 0));
  EXPECT_EQ(journal.find("a.geo", {{"a.geo", "", "00fe"}, {"x.ana", "", ""}}), nullptr);
  EXPECT_EQ(journal.find("a.geo", {{"a.geo", "", "00ff"}}), nullptr);
  EXPECT_EQ(journal.find("b.geo", some_row("a.geo").files), nullptr);
}

TEST(BatchJournal, a_torn_line_counts_as_none_wherever_it_is_torn) {
  const std::string whole = journal_head("check") + journal_line(some_row("a.geo"), 0);
  const std::string line = journal_line(some_row("b.geo"), 0);
  for (std::size_t length = 0; length < line.size(); ++length) {
    const Journal journal = read_journal(whole + line.substr(0, length));
    EXPECT_EQ(journal.rows.size(), 1U) << length;
    EXPECT_EQ(journal.lines, whole) << length;
  }
  EXPECT_EQ(read_journal(whole + line.substr(0, 40) + "\n" + line).rows.size(), 2U);
}

TEST(BatchJournal, a_journal_without_its_head_is_none) {
  EXPECT_EQ(read_journal("").task, "");
  EXPECT_TRUE(read_journal(journal_line(some_row("a.geo"), 0)).rows.empty());
}

TEST(BatchCatalogue, the_table_reads_back_cell_by_cell) {
  const auto table = formats::read_csv({"catalogue.csv", catalogue_csv({some_row("a, b.geo")})});
  ASSERT_EQ(table.rows.size(), 1U);
  const auto cell = [&](const char* name) { return table.rows[0].cells[formats::csv_column(table, name)]; };
  EXPECT_EQ(cell("job"), "a, b.geo");
  EXPECT_EQ(cell("files"), "a, b.geo | x.ana");
  EXPECT_EQ(cell("message"), "found \"a, b\"");
  EXPECT_EQ(cell("blocks"), "3");
  EXPECT_EQ(cell("elements"), "");
  EXPECT_EQ(cell("difference"), "0.001");
}

}  // namespace keyblock::study::batch_journal_test
