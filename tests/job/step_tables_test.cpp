// Tables of steps made from rows by hand, read back by their headings.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/step_tables.hpp"

#include <gtest/gtest.h>

#include "formats/text/csv.hpp"

namespace keyblock::step_tables_test {
namespace {

const Units kMillimetres{"mm", "t", "s"};

/// Every column has a number of its own.
StepReport step(int number) {
  StepReport report;
  report.step = number;
  report.time = 0.1 * number;
  report.dt = 0.1;
  report.passes = 100 + number;
  report.redos = 200 + number;
  report.fallbacks = 300 + number;
  report.contacts = 400 + number;
  report.closed = 500 + number;
  report.penalty = 1e9 / 3;
  report.greatest_penetration = 1.0 / 7;
  report.displacement_ratio = 0.25;
  report.residual = 1e-17;
  report.unsettled_contacts = 600 + number;
  report.parts = 700 + number;
  return report;
}

/// Returns the columns of the last row.
double last(const std::string& text, std::string_view column) {
  const formats::CsvTable table = formats::read_csv({"step_table.csv", text});
  return formats::csv_real(table, table.rows.back(), formats::csv_column(table, column));
}

}  // namespace

TEST(StepTables, numbers_of_steps_are_written_whole) {
  constexpr int kMany = 100000;
  const std::string text = step_table_csv({step(kMany)}, {});
  const std::string row = text.substr(text.find('\n') + 1);
  EXPECT_EQ(row.substr(0, row.find(',')), "100000");
}

TEST(StepTables, numbers_are_read_back_to_the_bit) {
  const std::string text = step_table_csv({step(1), step(2)}, kMillimetres);
  EXPECT_EQ(last(text, "step"), 2);
  EXPECT_EQ(last(text, "time"), 0.1 * 2);
  EXPECT_EQ(last(text, "dt"), 0.1);
  EXPECT_EQ(last(text, "passes"), 102);
  EXPECT_EQ(last(text, "redos"), 202);
  EXPECT_EQ(last(text, "fallbacks"), 302);
  EXPECT_EQ(last(text, "contacts"), 402);
  EXPECT_EQ(last(text, "closed"), 502);
  EXPECT_EQ(last(text, "penalty"), 1e9 / 3);
  EXPECT_EQ(last(text, "greatest_penetration"), 1.0 / 7);
  EXPECT_EQ(last(text, "displacement_ratio"), 0.25);
  EXPECT_EQ(last(text, "residual"), 1e-17);
  EXPECT_EQ(last(text, "unsettled_contacts"), 602);
  EXPECT_EQ(formats::read_csv({"step_table.csv", text}).rows.size(), 2U);
}

// With tonnes, millimetres and seconds force is in newtons; a slice is a millimetre thick.
TEST(StepTables, headings_name_units_where_the_case_declares_them) {
  const std::vector<std::string> with = step_columns({step(1)}, kMillimetres);
  EXPECT_EQ(with[1], "time [s]");
  EXPECT_EQ(with[2], "dt [s]");
  EXPECT_EQ(with[3], "passes");
  EXPECT_EQ(with[8], "penalty [N/mm/mm]");
  EXPECT_EQ(with[9], "greatest_penetration [mm]");
  EXPECT_EQ(with[10], "displacement_ratio");
  for (const std::string& name : step_columns({step(1)}, {})) EXPECT_EQ(name.find('['), std::string::npos) << name;
}

TEST(StepTables, parts_are_a_column_where_steps_have_rounds) {
  StepReport with_rounds = step(3);
  with_rounds.residuals = {1e-3, 1e-10};
  const std::vector<StepReport> rows{step(2), with_rounds};
  EXPECT_EQ(last(step_table_csv(rows, {}), "parts"), 703);
  EXPECT_EQ(step_columns(rows, {}).back(), "parts");
  EXPECT_EQ(step_columns(rows, {}).size(), step_columns({step(2)}, {}).size() + 1);
}

TEST(StepTables, without_steps_there_is_the_heading_alone) {
  const formats::CsvTable table = formats::read_csv({"step_table.csv", step_table_csv({}, kMillimetres)});
  EXPECT_TRUE(table.rows.empty());
  EXPECT_EQ(table.header, step_columns({}, kMillimetres));
}

}  // namespace keyblock::step_tables_test
