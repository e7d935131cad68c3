// Energy balances made by hand: their columns by scope, their table read back, and their closure.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/ledger_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "formats/text/csv.hpp"
#include "tests/support/ledger_sums.hpp"

namespace keyblock::ledger_report_test {
namespace {

using Json = nlohmann::ordered_json;

const Units kMetres{"m", "kg", "s"};

/// A body of 2 kg falls for a second at 10 m/s² and is pushed along by 3 N s. The balance loses 1 % of its energy.
Ledger fall() {
  LedgerRow start, end;
  start.stored.gravity = 500;
  start.momentum = {{1, 0}, 4};
  end.step = 10;
  end.time = 1;
  end.stored = {99, 0, 400, 0};
  end.flow.external = 6;
  end.flow.friction = 6;
  end.momentum = {{4, -20}, 9};
  end.impulse = {{3, -18}, 5};
  end.momentum_size = {40, 50};
  Ledger ledger{{.has_flows = true, .has_supports = false, .centre = {2, -3}}, {start, end}};
  return ledger;
}

/// Columns with and without flows, no supports, and one column more.
std::vector<std::string> names_of(bool has_flows, bool LedgerScope::*more = nullptr) {
  Ledger ledger = fall();
  ledger.scope.has_flows = has_flows;
  if (more != nullptr) ledger.scope.*more = true;
  return ledger_json(ledger, support::sums_of(ledger), 1, {})["columns"];
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

}  // namespace

TEST(LedgerReport, sums_closures_and_the_last_row_are_told_by_name) {
  const Ledger ledger = fall();
  const Json json = Json::parse(ledger_json(ledger, support::sums_of(ledger), 5, kMetres).dump());
  EXPECT_EQ(json["largest_energy"], 100) << "of gravity since the start";
  EXPECT_NEAR(json["closure"]["energy"].get<double>(), 1.0 / 100, 1e-15);
  EXPECT_NEAR(json["closure"]["linear_momentum"].get<double>(), 2.0 / 40, 1e-15);
  EXPECT_EQ(json["closure"]["angular_momentum"], 0);
  EXPECT_EQ(json["momentum_about"], Json({2, -3}));
  EXPECT_EQ(json["end"]["kinetic"], 99);
  EXPECT_EQ(json["end"]["friction"], 6);
  EXPECT_EQ(json["end"]["momentum_y"], -20);
  EXPECT_EQ(json["end"]["angular_impulse"], 5);
  EXPECT_EQ(json["table"], "ledger.csv");
  EXPECT_EQ(json["kept_every"], 5);
}

TEST(LedgerReport, the_table_is_read_back_under_the_names_of_the_record) {
  const Ledger ledger = fall();
  const formats::CsvTable table =
      formats::read_csv({"ledger.csv", ledger_csv(ledger, support::sums_of(ledger), kMetres)});
  const Json json = ledger_json(ledger, support::sums_of(ledger), 1, kMetres);
  EXPECT_EQ(Json(table.header), json["columns"]);
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.header[1], "time [s]");
  for (const auto& [name, value] : json["end"].items())
    EXPECT_EQ(formats::csv_real(table, table.rows[1], formats::csv_column(table, name)), value) << name;
  EXPECT_EQ(formats::csv_real(table, table.rows[0], formats::csv_column(table, "gravity")), 500);
  EXPECT_EQ(formats::csv_real(table, table.rows[1], 0), 10);
}

// Supports gave the change of momentum that loads do not explain.
TEST(LedgerReport, supports_give_what_loads_leave_of_the_change_of_momentum) {
  Ledger ledger = fall();
  ledger.scope.has_supports = true;
  const Json json = ledger_json(ledger, support::sums_of(ledger), 1, {});
  EXPECT_EQ(json["end"]["reaction_impulse_x"], (4 - 1) - 3);
  EXPECT_EQ(json["end"]["reaction_impulse_y"], -20 - -18);
  EXPECT_EQ(json["end"]["angular_reaction_impulse"], (9 - 4) - 5);
  EXPECT_TRUE(json["closure"].contains("energy"));
  EXPECT_FALSE(json["closure"].contains("linear_momentum")) << "is not meant to close";
}

TEST(LedgerReport, columns_are_those_that_the_scene_has_something_to_say_in) {
  const std::vector<std::string> stored = names_of(false);
  EXPECT_EQ(stored, (std::vector<std::string>{"step", "time", "kinetic", "strain", "gravity", "momentum_x",
                                              "momentum_y", "angular_momentum"}));
  EXPECT_TRUE(has(names_of(false, &LedgerScope::has_work), "external"));
  const std::vector<std::string> flows = names_of(true);
  for (const char* name : {"contact", "external", "damping", "impact", "clean_up", "algorithmic", "impulse_x"})
    EXPECT_TRUE(has(flows, name)) << name;
  for (const char* name : {"plastic", "fracture", "change", "reaction_impulse_x"})
    EXPECT_FALSE(has(flows, name)) << name;
  EXPECT_TRUE(has(names_of(true, &LedgerScope::may_yield), "plastic"));
  EXPECT_TRUE(has(names_of(true, &LedgerScope::may_crack), "fracture"));
  EXPECT_TRUE(has(names_of(true, &LedgerScope::has_changes), "change"));
  EXPECT_FALSE(has(names_of(false, &LedgerScope::may_yield), "plastic"));
}

TEST(LedgerReport, stored_energies_alone_close_nothing) {
  Ledger ledger = fall();
  ledger.scope.has_flows = false;
  EXPECT_TRUE(ledger_json(ledger, support::sums_of(ledger), 1, {})["closure"].empty());
}

TEST(LedgerReport, without_rows_there_is_no_end) {
  const Json json = ledger_json({}, {}, 1, {});
  EXPECT_TRUE(json["end"].is_object());
  EXPECT_TRUE(json["end"].empty());
  EXPECT_EQ(json["largest_energy"], 0);
}

}  // namespace keyblock::ledger_report_test
