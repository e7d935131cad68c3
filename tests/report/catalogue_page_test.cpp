// The page of a catalogue holds every row, and no text of a file counts as markup; small pictures stay small.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/catalogue_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "report/thumbnail.hpp"
#include "tests/support/two_triangles.hpp"

namespace keyblock::report::catalogue_page_test {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

Blocks squares(int number) {
  Blocks blocks;
  for (int i = 0; i < number; ++i) {
    const double x = i;
    blocks.blocks.push_back({0, {{{x, 0}, 0}, {{x + 1, 0}, 0}, {{x + 1, 1}, 0}, {{x, 1}, 0}}, {}});
  }
  return blocks;
}

}  // namespace

TEST(CataloguePage, has_a_card_a_row_and_a_section_per_job) {
  CatalogueRow row;
  row.name = "a<b>&c";
  row.files = {{"a<b>&c", "ddaml", "ff"}};
  row.outcome = "failed";
  row.message = "found \"<script>\"";
  const std::string page = catalogue_page("All", {row, row});
  EXPECT_EQ(count(page, "<li class=\"card bad\" data-state=\"failed\">"), 2U);
  EXPECT_EQ(count(page, "<section id=\"job-"), 2U);
  EXPECT_EQ(count(page, "<script>"), 1U);
  EXPECT_NE(page.find("a&lt;b&gt;&amp;c"), std::string::npos);
  EXPECT_NE(page.find("2 jobs: 2 failed (100 %)"), std::string::npos);
  EXPECT_EQ(count(page, "http"), 0U);  // it loads nothing
}

TEST(CataloguePage, a_file_that_is_no_case_has_a_row_and_no_card) {
  CatalogueRow row;
  row.name = "expected.csv";
  row.outcome = "listed";
  row.verdict = {"listed", "no case"};
  const std::string page = catalogue_page("All", {row});
  EXPECT_EQ(count(page, "class=\"card"), 0U);
  EXPECT_EQ(count(page, "0 cases on cards, 1 job in the table below"), 1U);
  EXPECT_EQ(count(page, "<section id=\"job-"), 1U);
}

TEST(CataloguePage, a_reason_is_said_once_and_another_message_beside_it) {
  CatalogueRow failed;
  failed.outcome = failed.verdict.word = "failed";
  failed.message = failed.verdict.why = "no block closes";
  EXPECT_EQ(count(catalogue_page("All", {failed}), "no block closes"), 2U) << "on the card and in the table";
  CatalogueRow differs;
  differs.outcome = "warnings";
  differs.warnings = 3;
  differs.message = "a sliver";
  differs.verdict = {"differs", "96 % apart"};
  const std::string page = catalogue_page("All", {differs});
  EXPECT_NE(page.find("96 % apart; first of 3 warnings and notes: a sliver"), std::string::npos) << page;
  EXPECT_NE(page.find("<li class=\"card doubtful\" data-state=\"differs\">"), std::string::npos);
  EXPECT_EQ(count(page, "<option>differs</option>"), 1U);
}

TEST(CataloguePage, runs_are_linked_with_picture_record_and_log_and_counted_by_verdict) {
  CatalogueRow row;
  row.name = "50%25.geo";
  row.outcome = "ok";
  row.verdict = {"differs", "96 % apart"};
  row.answers = {{"legacy", "finished", 10, 0.5, "", 0, 0, CatalogueMeasures{}},
                 {"standard", "no result", 0, 0, "", 0, 0, std::nullopt}};
  row.outputs = {"jobs/50%25.geo/legacy", "jobs/50%25.geo/standard"};
  CatalogueRow other;
  other.verdict.word = "read";
  const std::string page = catalogue_page("All", {row, other, other});
  EXPECT_EQ(count(page, "<a href=\"jobs/50%2525.geo/legacy/picture.svg\""), 1U);
  EXPECT_EQ(count(page, "src=\"jobs/50%2525.geo/legacy/picture.svg\""), 1U);
  EXPECT_EQ(count(page, "<a href=\"jobs/50%2525.geo/legacy/run.json\""), 1U);
  EXPECT_EQ(count(page, "<a href=\"jobs/50%2525.geo/standard.log\""), 1U);
  EXPECT_EQ(count(page, "standard/picture.svg"), 0U) << "there is none";
  EXPECT_NE(page.find("3 jobs: 1 differs (33 %), 2 read (67 %)"), std::string::npos);
  EXPECT_NE(page.find("96 % apart"), std::string::npos);
}

TEST(CataloguePage, an_answer_is_told_with_its_length) {
  CatalogueAnswer answer{"legacy", "finished", 10, 0.5, "measured point 1", 3, -4, std::nullopt};
  EXPECT_EQ(text_of(answer), "measured point 1 moved by (3, -4), 5, at time 0.5; finished, 10 steps");
  answer.measures = CatalogueMeasures{7, -2, 0.5, 12, true, 0.125};
  EXPECT_EQ(text_of(answer),
            "measured point 1 moved by (3, -4), 5, at time 0.5; at most 7 anywhere, principal stress -2 to 0.5, 12 "
            "contacts or fewer, about 12.5 % of the way to equilibrium; finished, 10 steps");
  answer.measures = CatalogueMeasures{7, -2, 0.5, 0, true, std::nullopt};
  EXPECT_NE(text_of(answer).find("no contact, no sign of an equilibrium;"), std::string::npos);
  EXPECT_EQ(text_of({"legacy", "no result", 0, 0, "", 0, 0, std::nullopt}), "no result, 0 steps");
}

TEST(Thumbnail, draws_blocks_loops_and_lines_up_to_a_bound) {
  EXPECT_EQ(count(thumbnail(squares(3)), "<path"), 3U);
  EXPECT_EQ(count(thumbnail(squares(1000)), "<path"), kThumbnailShapes);
  EXPECT_EQ(count(thumbnail(support::two_triangles()), "M"), 2U);
  Drawing drawing;
  drawing.joints = {{{{0, 0}, {1, 0}}, 0, {}}, {{{0, 0}, {0, 1}}, 0, {}}};
  EXPECT_EQ(count(thumbnail(drawing), "<polyline"), 2U);
  EXPECT_EQ(count(thumbnail(squares(3), {{{0, 0}, {1, 1}}}), "<polyline"), 1U) << "a crack";
  EXPECT_TRUE(thumbnail(Blocks{}).starts_with("<svg"));
}

}  // namespace keyblock::report::catalogue_page_test
