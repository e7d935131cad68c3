// Units that a case declares stand in its tables and pictures.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/declared_units.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::declared_units_test {

// Force is mass times length over time squared: 1 t m/s² is 1 kN, 1 t mm/s² is 1 N, and N/mm² are MPa.
TEST(DeclaredUnits, force_and_stress_follow_from_the_base_units) {
  EXPECT_EQ(force_unit({"m", "kg", "s"}), "N");
  EXPECT_EQ(stress_unit({"m", "kg", "s"}), "Pa");
  EXPECT_EQ(force_unit({"m", "t", "s"}), "kN");
  EXPECT_EQ(stress_unit({"m", "t", "s"}), "kPa");
  EXPECT_EQ(force_unit({"mm", "t", "s"}), "N");
  EXPECT_EQ(stress_unit({"mm", "t", "s"}), "MPa");
  EXPECT_EQ(force_unit({"ft", "slug", "s"}), "slug ft/s²");
  EXPECT_EQ(force_unit({"m", "", "s"}), "");
}

TEST(DeclaredUnits, letters_become_names_in_the_first_line_of_a_table) {
  EXPECT_EQ(table_in_units("time [T],x1 [L],f [F],w [F L],s [F/L²]\n[L]\n", {"mm", "t", "s"}),
            "time [s],x1 [mm],f [N],w [N mm],s [MPa]\n[L]\n");
  EXPECT_EQ(table_in_units("time [T],x1 [L],f [F]\n", {"m", "", ""}), "time [T],x1 [m],f [F]\n");
  EXPECT_EQ(table_in_units("time [T]\n", {}), "time [T]\n");
}

TEST(DeclaredUnits, a_run_names_them_in_every_table_and_picture) {
  const std::string folder = support::fresh_folder("declared_units");
  ASSERT_EQ(support::run_keyblock({"new", "block", "-o", folder + "/block.json"}).exit_code, 0);
  ASSERT_EQ(support::run_keyblock({"run", folder + "/block.json", "-o", folder + "/out"}).exit_code, 0);
  for (const char* table : {"history.csv", "points.csv"}) {
    const std::string head = support::read_text(folder + "/out/" + table);
    EXPECT_NE(head.find("time [s]"), std::string::npos) << head.substr(0, 100);
    EXPECT_EQ(head.find("[L]"), std::string::npos) << head.substr(0, 100);
  }
  for (const char* picture : {"picture.svg", "energy.svg"}) {
    const std::string svg = support::read_text(folder + "/out/" + picture);
    for (const char* letters : {"[L]", "[T]", "[F L", "unit of length of the input"})
      EXPECT_EQ(svg.find(letters), std::string::npos) << picture << ": " << letters;
  }
  EXPECT_EQ(nlohmann::json::parse(support::read_text(folder + "/out/run.json"))["units"]["length"], "m");
}

}  // namespace keyblock::declared_units_test
