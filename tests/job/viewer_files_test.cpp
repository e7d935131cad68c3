// Files of a run for viewers, read back by VTK's own readers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::viewer_files_test {
namespace {

using support::fresh_folder;
using support::run_keyblock;
using support::run_script;
using support::write_text;

/// The quantities that tests/support/read_vtk.py prints; none if no Python with VTK is installed.
std::map<std::string, double> read_by_vtk(const std::string& folder) {
  const auto read =
      run_script(fmt::format("for p in /usr/bin/python3 python3; do command -v $p >/dev/null || continue; "
                             "$p '{}/tests/support/read_vtk.py' '{}'; c=$?; test $c = 3 || exit $c; done; exit 3",
                             KEYBLOCK_SOURCE_DIR, folder));
  EXPECT_TRUE(read.exit_code == 0 || read.exit_code == 3) << read.messages;
  EXPECT_EQ(read.messages, "") << "VTK's readers complain";
  std::map<std::string, double> values;
  std::istringstream lines(read.output);
  std::string name;
  for (double value = 0; lines >> name >> value;) values[name] = value;
  return values;
}

constexpr double kWeight = 24525;

/// A fixed floor, two squares on it, and a bolt of constant pull between the lower one and the floor.
const char* const kCase = R"({"keyblock": 1,
  "blocks": {"blocks": [{"outer": [[-2, -1, 1], [3, -1, 1], [3, 0, 1], [-2, 0, 1]]},
                        {"outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]},
                        {"outer": [[0, 1, 1], [1, 1, 1], [1, 2, 1], [0, 2, 1]]}],
    "fixed_points": [[-1, -0.5, 1], [2, -0.5, 1]], "bolts": [BOLT]},
  "analysis": {"step_count": 20, "time_step": 0.001, "allowed_displacement_ratio": 0.01, "velocity_carry_over": 1,
    "joint_materials": [{"friction_angle_deg": 30}],
    "block_materials": [{"density": 2500, "unit_weight": 24525, "youngs_modulus": 5e9, "poissons_ratio": 0.25}]}})";

std::string last_folder;  // of the latest run

/// Two walls of two blocks each, between them a bed and a cross joint, in metres.
const char* const kJointed = R"({"keyblock": 2, "units": {"length": "m", "mass": "kg", "time": "s"},
  "drawing": {"boundary_count": 4, "fixed_lines": [[0, 0, 10, 0]],
    "joints": [[0, 0, 10, 0, 1], [10, 0, 10, 6, 1], [10, 6, 0, 6, 1], [0, 6, 0, 0, 1],
               [0, 3, 10, 3, 1], [5, 0, 5, 6, 2]]},
  "analysis": {"step_count": 20, "time_step": 0.001, "gravity": 9.81,
    "joint_materials": [{"friction_angle_deg": 30}, {"friction_angle_deg": 20}],
    "block_materials": [{"density": 2500, "youngs_modulus": 5e9, "poissons_ratio": 0.25}]}})";

std::map<std::string, double> seen_of_case(const std::string& text, const std::string& name) {
  const std::string folder = fresh_folder(name);
  write_text(folder + "/case.json", text);
  EXPECT_EQ(run_keyblock({"run", folder + "/case.json", "-o", folder + "/out"}).exit_code, 0);
  last_folder = folder;
  return read_by_vtk(folder + "/out");
}

std::map<std::string, double> seen_of_run(const std::string& bolts, const std::string& name = "viewer_files") {
  std::string text = kCase;
  text.replace(text.find("[BOLT]"), 6, bolts);
  return seen_of_case(text, name);
}

/// Sums of the columns of contacts.csv over the rows of the last step.
std::map<std::string, double> last_sums_of(const std::string& file) {
  std::istringstream lines(support::read_text(file));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string>& cells = rows.emplace_back();
    std::istringstream parts(line);
    for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(cell);
  }
  std::map<std::string, double> sums;
  for (std::size_t i = 1; i < rows.size(); ++i)
    for (std::size_t k = 0; k < rows[i].size(); ++k)
      if (rows[i][0] == rows.back()[0] && rows[0][k] != "state") sums[rows[0][k]] += std::stod(rows[i][k]);
  return sums;
}

constexpr const char* kNoVtk = "no Python with VTK (python3-vtk9) is installed";

}  // namespace

TEST(ViewerFiles, vtk_reads_contacts_whose_forces_bear_the_blocks_and_corners_that_warp_back_to_the_drawing) {
  const auto seen = seen_of_run("[]");
  if (seen.empty()) GTEST_SKIP() << kNoVtk;
  EXPECT_EQ(seen.at("blocks"), 3);
  EXPECT_EQ(seen.at("contacts"), 4);
  EXPECT_NEAR(seen.at("time"), 0.02, 1e-12);
  EXPECT_EQ(seen.at("held"), 1);
  EXPECT_NEAR(seen.at("force_y_on_1") / kWeight, -2, 1e-9);
  EXPECT_NEAR(seen.at("force_y_on_2") / kWeight, 1, 1e-9);
  EXPECT_NEAR(seen.at("force_y_on_3") / kWeight, 1, 1e-9);
  EXPECT_NEAR(seen.at("lowest_drawn"), -1, 1e-12);
  EXPECT_NEAR(seen.at("highest_drawn"), 2, 1e-12);
  EXPECT_NEAR(seen.at("most_pressed") / (-1.5 * kWeight), 1, 0.05) << "the mean of the lower square";
}

// VTK's reader has the contacts of the table, column by column.
TEST(ViewerFiles, vtk_and_the_table_of_contacts_have_the_same_sums) {
  const auto seen = seen_of_run("[]", "viewer_sums");
  if (seen.empty()) GTEST_SKIP() << kNoVtk;
  const auto sums = last_sums_of(last_folder + "/out/contacts.csv");
  EXPECT_NEAR(seen.at("sum_normal_force") / sums.at("normal_force [F]"), 1, 1e-11);
  EXPECT_NEAR(seen.at("sum_normal_force") / (3 * kWeight), 1, 1e-9) << "one square on the other, and both on the floor";
  EXPECT_NEAR(seen.at("sum_shear_force"), sums.at("shear_force [F]"), 1e-9 * kWeight);
  EXPECT_NEAR(seen.at("sum_gap"), sums.at("gap [L]"), 1e-15);
  EXPECT_NEAR(seen.at("sum_slip"), sums.at("slip [L]"), 1e-15);
  EXPECT_EQ(seen.at("sum_joint"), sums.at("joint"));
  EXPECT_EQ(seen.at("sum_state"), 4) << "all stick";
  EXPECT_LT(seen.at("force_misfit"), 1e-9 * kWeight);
}

TEST(ViewerFiles, vtk_reads_joints_of_all_instants_with_the_sums_of_the_table_of_contacts) {
  const auto seen = seen_of_case(kJointed, "viewer_joints");
  if (seen.empty()) GTEST_SKIP() << kNoVtk;
  EXPECT_EQ(seen.at("joint_rows"), 21 * 3) << "two pieces of the bed, one of the cross joint, 21 frames";
  EXPECT_EQ(seen.at("joints_not_seen"), 0);
  EXPECT_LT(seen.at("joint_misfit"), 1e-11) << "the table has twelve digits";
  EXPECT_EQ(seen.at("clock_misfit"), 0);
  EXPECT_EQ(seen.at("named_parts"), 3) << "blocks, contacts, joints";
  EXPECT_NEAR(seen.at("length_of_joints"), 13, 1e-3) << "the walls part below";
  EXPECT_EQ(seen.at("forces_with_unit"), 2);
}

TEST(ViewerFiles, vtk_reads_bolts_with_their_force) {
  const auto seen = seen_of_run("[[0.5, -0.5, 0.5, 0.5, 1, 2, 0, 0, 1000]]");
  if (seen.empty()) GTEST_SKIP() << kNoVtk;
  EXPECT_EQ(seen.at("bolts"), 1);
  EXPECT_EQ(seen.at("named_parts"), 4);
  EXPECT_EQ(seen.at("bolt_force"), 1000);
  EXPECT_NEAR(seen.at("force_y_on_2") / (kWeight + 1000), 1, 1e-9) << "weight and pull";
  EXPECT_NEAR(seen.at("force_y_on_1") / (2 * kWeight + 1000), -1, 1e-9);
}

}  // namespace keyblock::viewer_files_test
