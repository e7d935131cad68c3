// A row of the catalogue comes back from its JSON, and its cells survive the table.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/batch/batch_catalogue.hpp"

#include <gtest/gtest.h>

#include "formats/text/csv.hpp"

namespace keyblock::study::batch_catalogue_test {
namespace {

report::CatalogueRow full_row() {
  report::CatalogueRow row;
  row.name = "a, \"b\".geo";
  row.files = {{"a.geo", "dda-geometry", "12"}, {"a.ana", "ddaml", "34"}};
  row.paired_by = "the same name";
  row.blocks = 3;
  row.steps = 10;
  row.outcome = "warnings";
  row.warnings = 2;
  row.message = "two\nlines";
  row.answers = {
      {"legacy", "finished", 10, 0.5, "measured point 1", 3, 4, report::CatalogueMeasures{7, -2, 0.5, 12, true, 0.125}},
      {"standard", "finished", 10, 0.5, "measured point 1", 3, 4,
       report::CatalogueMeasures{8, -3, 0.25, 0, true, std::nullopt}},
      {"draft", "no result", 0, 0, "", 0, 0, std::nullopt, "", "no_equilibrium"}};
  row.scene = "static, 10 steps of 0.05";
  row.difference = 0.25;
  row.expected = "legacy: hold";
  row.outputs = {"jobs/a/legacy", "jobs/a/standard"};
  row.thumbnail = "<svg/>";
  return row;
}

}  // namespace

TEST(BatchCatalogue, a_row_comes_back_from_its_json) {
  const nlohmann::ordered_json json = json_of(full_row());
  EXPECT_EQ(json_of(row_of(json)), json);
  EXPECT_TRUE(json["elements"].is_null());
  EXPECT_EQ(row_of(json).files.at(1).sha256, "34");
  nlohmann::ordered_json torn = json;
  torn.erase("outcome");
  EXPECT_THROW(row_of(torn), nlohmann::json::exception);
}

TEST(BatchCatalogue, the_table_keeps_commas_quotes_and_line_ends) {
  const formats::CsvTable table = formats::read_csv({"catalogue.csv", catalogue_csv({full_row()})});
  const auto cell = [&](const char* heading) { return table.rows.at(0).cells.at(formats::csv_column(table, heading)); };
  EXPECT_EQ(cell("job"), "a, \"b\".geo");
  EXPECT_EQ(cell("files"), "a.geo | a.ana");
  EXPECT_EQ(cell("dialect"), "dda-geometry + ddaml");
  EXPECT_EQ(cell("elements"), "");
  EXPECT_EQ(cell("message"), "two\nlines");
  EXPECT_EQ(cell("difference"), "0.25");
  EXPECT_EQ(cell("scene"), "static, 10 steps of 0.05");
  EXPECT_EQ(cell("profiles"), "legacy | standard | draft");
  EXPECT_EQ(cell("ends"), "finished | finished | no result");
  EXPECT_EQ(cell("greatest_displacement"), "7 | 8 | none");
  EXPECT_EQ(cell("least_stress"), "-2 | -3 | none");
  EXPECT_EQ(cell("greatest_stress"), "0.5 | 0.25 | none");
  EXPECT_EQ(cell("equilibrium_share"), "0.125 | none known | none");
  EXPECT_EQ(cell("outputs"), "jobs/a/legacy | jobs/a/standard");
}

TEST(BatchCatalogue, the_json_has_every_row_without_its_picture) {
  const auto json = nlohmann::json::parse(catalogue_json({full_row(), {}}));
  ASSERT_EQ(json["jobs"].size(), 2U);
  EXPECT_FALSE(json["jobs"][0].contains("thumbnail"));
}

}  // namespace keyblock::study::batch_catalogue_test
