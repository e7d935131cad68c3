// Histories and contact tables, requested by options of `run` and by the case file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <vector>

#include "tests/support/killed_runs.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::histories_command_test {
namespace {

using support::fresh_folder;
using support::read_text;
using support::run_keyblock;
using support::write_text;

constexpr double kWeight = 24525;  // N per metre of the square metre: 2500 kg/m3, 9.81 m/s2

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Three square metres on each other, cut from a drawing: the outline is joints 1 to 4, the joints between them are 5
/// and 6. The lowest is fixed. `more`: keys of the case.
std::string column(const std::string& more = "") {
  return R"({"keyblock": 2, "units": {"length": "m", "mass": "kg", "time": "s"},
  "drawing": {"boundary_count": 4, "edge_node_ratio": 0.001,
    "joints": [[0, 0, 1, 0, 1], [1, 0, 1, 3, 1], [1, 3, 0, 3, 1], [0, 3, 0, 0, 1], [0, 1, 1, 1, 1], [0, 2, 1, 2, 1]],
    "fixed_lines": [[0.2, 0.5, 0.2, 0.5], [0.8, 0.5, 0.8, 0.5]]},
  "analysis": {"step_count": 20, "time_step": 0.001, "gravity": 9.81,
    "block_materials": [{"density": 2500, "youngs_modulus": 5e9, "poissons_ratio": 0.25}],
    "joint_materials": [{"friction_angle_deg": 30}]})" +
         more + "}";
}

std::vector<std::vector<std::string>> rows_of(const std::string& file) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(read_text(file));
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string>& cells = rows.emplace_back();
    std::istringstream parts(line);
    for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(cell);
  }
  return rows;
}

/// Returns the last value of each "what name quantity", and its unit behind a blank.
std::map<std::string, std::pair<double, std::string>> last_of(const std::string& file) {
  std::map<std::string, std::pair<double, std::string>> last;
  for (const auto& row : rows_of(file))
    if (row.size() == 7 && row[0] != "step") last[row[2] + " " + row[3] + " " + row[4]] = {std::stod(row[5]), row[6]};
  return last;
}

std::size_t lines_of(const std::string& file) {
  return rows_of(file).size();
}

std::string case_in(const std::string& name, const std::string& more = "") {
  const std::string folder = fresh_folder(name);
  write_text(folder + "/case.json", column(more));
  return folder;
}

}  // namespace

TEST(HistoriesCommand, all_kinds_come_in_long_form_with_units) {
  const std::string folder = case_in("histories");
  const std::string out = folder + "/out";
  const auto run =
      run_keyblock({"run", folder + "/case.json", "-o", out, "--history", "top=point:0.5,2.5", "--history", "block:3",
                    "--history", "contact:3,2", "--history", "joint:6", "--history", "all=line:-1,1,2,1"});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_TRUE(read_text(out + "/histories.csv").starts_with("step,time [s],what,name,quantity,value,unit\n"));
  const auto last = last_of(out + "/histories.csv");
  EXPECT_EQ(last.at("point top displacement_y").second, "m");
  EXPECT_EQ(last.at("point top velocity_x").second, "m/s");
  EXPECT_EQ(last.at("block 3 stress_yy").second, "Pa");
  EXPECT_EQ(last.at("block 3 rotation").second, "rad");
  EXPECT_LT(last.at("block 3 stress_yy").first, 0);
  EXPECT_NEAR(last.at("block 3 contact_force_y").first / kWeight, 1, 1e-6) << "it carries its weight";
  EXPECT_NEAR(last.at("contact 3-2 force_y").first / kWeight, -1, 1e-6) << "on the first, which lies below the second";
  EXPECT_NEAR(last.at("joint 6 normal_force").first / kWeight, 1, 1e-6);
  EXPECT_EQ(last.at("joint 6 normal_force").second, "N/m");
  EXPECT_NEAR(last.at("line all force_y").first / (2 * kWeight), 1, 1e-6);
  EXPECT_NEAR(last.at("line all normal_force").first / (2 * kWeight), 1, 1e-6);
  const auto rows = rows_of(out + "/histories.csv");
  EXPECT_EQ(rows[1][0], "0") << "from the start";
  EXPECT_EQ(rows.back()[0], "20") << "to the end";
}

// Each history searches only the measured points of its own.
TEST(HistoriesCommand, many_of_one_point_share_a_measured_point_and_large_tables_are_told_of_before_the_run) {
  std::string rows;
  for (int i = 0; i < 5000; ++i)
    rows += (i == 0 ? R"({"name": ")" : R"(, {"name": ")") + std::to_string(i) + R"(", "point": [0.5, 2.5]})";
  const std::string folder = case_in("many_histories", R"(, "outputs": {"histories": [)" + rows + "]}");
  const auto run = run_keyblock({"run", folder + "/case.json", "-o", folder + "/out", "--set", "steps=3"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_FALSE(contains(run.messages, "[tables_large]")) << run.messages;
  EXPECT_LT(run.cpu_seconds, 10);
  EXPECT_EQ(lines_of(folder + "/out/histories.csv"), 1 + 4 * 5000 * 7);
  EXPECT_FALSE(contains(read_text(folder + "/out/history.csv"), "x2 [m]"));
  const auto longer =
      support::interrupt_keyblock({"run", folder + "/case.json", "-o", folder + "/longer", "--set", "steps=1000000"},
                                  folder + "/longer/frames/00000000.vtu");
  EXPECT_EQ(longer.exit_code, 130);
  EXPECT_TRUE(contains(longer.messages, " MB of 5000 histories, history.csv and points.csv ")) << longer.messages;
}

TEST(HistoriesCommand, a_case_file_asks_for_them_too) {
  const std::string folder = case_in("histories_case", R"(, "outputs": {"histories": [
      {"name": "roof", "point": [0.5, 3]}, {"block": 2}, {"contact": [1, 3]}, {"joint": 5},
      {"line": [-1, 2, 2, 2]}]})");
  ASSERT_EQ(run_keyblock({"run", folder + "/case.json", "-o", folder + "/out"}).exit_code, 0);
  const auto last = last_of(folder + "/out/histories.csv");
  EXPECT_TRUE(last.contains("point roof displacement_x"));
  EXPECT_NEAR(last.at("contact 1-3 force_y").first / (-2 * kWeight), 1, 1e-6) << "pressed down by the blocks on it";
  EXPECT_NEAR(last.at("joint 5 normal_force").first / (2 * kWeight), 1, 1e-6);
  EXPECT_NEAR(last.at("line -1 2 to 2 2 force_y").first / kWeight, 1, 1e-6);
}

// The lowest block, 1, and the highest, 2, are never in contact. The line passes above all blocks, and the left side of
// the outline has no neighbour. All values are zero.
TEST(HistoriesCommand, what_bears_nothing_is_told_by_name_at_the_end) {
  const std::string folder = case_in("histories_of_nothing");
  const auto run =
      run_keyblock({"--verbose", "run", folder + "/case.json", "-o", folder + "/out", "--history", "far=contact:1,2",
                    "--history", "contact:1,3", "--history", "joint:4", "--history", "joint:5", "--history",
                    "line:-1,9,2,9", "--history", "block:3", "--history", "point:0.5,2.5"});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_TRUE(contains(run.messages,
                       "history \"contact far\": no contact of blocks 1 and 2 is closed in any of its "
                       "rows, so that its forces are 0"))
      << run.messages;
  EXPECT_TRUE(contains(run.messages, "before any load they are 1 apart")) << run.messages;
  EXPECT_TRUE(contains(run.messages, "history \"joint 4\": no contact along joint 4 of the drawing is closed"));
  EXPECT_TRUE(contains(run.messages, "history \"line -1 9 to 2 9\": no closed contact and no bolt crosses the line"));
  const auto record = nlohmann::json::parse(read_text(folder + "/out/run.json"));
  int told = 0;
  for (const auto& warning : record["warnings"]) {
    EXPECT_NE(warning["name"], "history_of_distant_blocks") << "a metre apart, and larger than that";
    if (warning["name"] == "history_of_nothing") told = warning["count"];
  }
  EXPECT_EQ(told, 3) << "no warning is due for blocks that carry load, nor for lines without contact: " << run.messages;
}

TEST(HistoriesCommand, blocks_far_apart_are_told_before_the_first_step_and_by_check) {
  const std::string folder = fresh_folder("histories_distant");
  std::string text = column(R"(, "outputs": {"histories": [{"contact": [1, 2]}, {"contact": [1, 3]},
      {"contact": [1, 4]}, {"contact": [2, 3]}, {"contact": [2, 4]}, {"contact": [3, 4]}]})");
  const std::string high = "[1, 3, 0, 3, 1]";
  ASSERT_TRUE(contains(text, high));
  text.replace(text.find(high), high.size(), "[1, 3, 0, 3, 1], [0, 2.7, 1, 2.7, 1]");
  write_text(folder + "/case.json", text);
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"check", folder + "/case.json"},
        std::vector<std::string>{"run", folder + "/case.json", "-o", folder + "/out", "--verbose"}}) {
    const auto run = run_keyblock(arguments);
    const std::string all = run.output + run.messages;
    EXPECT_TRUE(contains(all, "are 1.7 apart before any load, farther than the smaller of them is large")) << all;
    EXPECT_TRUE(contains(all, "[history_of_distant_blocks]\n")) << "of one pair alone, not \"2 times\": " << all;
  }
}

TEST(HistoriesCommand, without_a_choice_the_table_has_what_moves_most) {
  const std::string folder = case_in("histories_none");
  ASSERT_EQ(run_keyblock({"run", folder + "/case.json", "-o", folder + "/out"}).exit_code, 0);
  const auto rows = rows_of(folder + "/out/histories.csv");
  ASSERT_GT(rows.size(), 3U);
  EXPECT_EQ(rows[1][2], "block");
  EXPECT_EQ(rows[1][4], "displacement_x");
  EXPECT_EQ(rows[1][6], "m");
}

// Two squares rest on the floor and ten fall: columns and curves are of those that fall, under their own numbers.
TEST(HistoriesCommand, of_many_blocks_the_table_and_the_picture_have_those_that_move_most) {
  std::string blocks = R"({"outer": [[0, 0, 1], [40, 0, 1], [40, 1, 1], [0, 1, 1]]})";
  for (int i = 0; i < 12; ++i) {
    const int x = 1 + 3 * i, y = i < 2 ? 1 : 5;
    blocks += ", {\"outer\": [[" + std::to_string(x) + ", " + std::to_string(y) + ", 1], [" + std::to_string(x + 1) +
              ", " + std::to_string(y) + ", 1], [" + std::to_string(x + 1) + ", " + std::to_string(y + 1) + ", 1], [" +
              std::to_string(x) + ", " + std::to_string(y + 1) + ", 1]]}";
  }
  const std::string folder = fresh_folder("histories_many");
  write_text(folder + "/case.json",
             R"({"keyblock": 2, "units": {"length": "m", "mass": "kg", "time": "s"}, "blocks": {"blocks": [)" + blocks +
                 R"(], "fixed_points": [[1, 0.5, 1], [39, 0.5, 1]]}, "analysis": {"step_count": 100, "time_step": 0.002,
                 "gravity": 9.81, "block_materials": [{"density": 2500, "youngs_modulus": 5e9, "poissons_ratio": 0.25}],
                 "joint_materials": [{"friction_angle_deg": 30}]}})");
  const auto run = run_keyblock({"run", folder + "/case.json", "-o", folder + "/out", "--field", "von_mises"});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  const auto rows = rows_of(folder + "/out/history.csv");
  ASSERT_EQ(rows[0].size(), 2U + 4 * 10);
  EXPECT_EQ(rows[0][2], "x4 [m]");
  EXPECT_EQ(rows[0][38], "x13 [m]");
  EXPECT_NEAR(std::stod(rows.back()[5]), -9.81 * 0.2 * 0.2 / 2, 1e-9);
  const std::string picture = read_text(folder + "/out/picture.svg");
  EXPECT_TRUE(contains(picture, ">block whose curve is drawn<"));
  EXPECT_TRUE(contains(picture, ">4<") && contains(picture, ">9<") && !contains(picture, ">3<"));
  EXPECT_TRUE(std::regex_search(read_text(folder + "/out/field.svg"), std::regex(">von Mises stress \\[[kM]?Pa\\]<")));
}

// The line y = 0.5 cuts the lowest square; y = 1 lies between it and the next.
TEST(HistoriesCommand, a_line_through_a_body_on_covers_is_refused) {
  const std::string folder = case_in("histories_covers", R"(, "covers": {"mesh": {"side": 0.3}})");
  const auto run_with = [&](const std::string& line) {
    return run_keyblock({"run", folder + "/case.json", "-o", folder + "/out", "--force", "--history", line});
  };
  const auto through = run_with("line:-1,0.5,2,0.5");
  EXPECT_EQ(through.exit_code, 3) << through.messages;
  EXPECT_TRUE(contains(through.messages, "found one through an NMM body")) << through.messages;
  const auto between = run_with("line:-1,1,2,1");
  EXPECT_EQ(between.exit_code, 0) << between.messages;
}

// Corners of supports lie at the ends of the line, up to round-off or to the bulge of the rock.
TEST(HistoriesCommand, a_line_from_side_to_side_has_the_corners_at_its_ends) {
  const std::string folder = case_in("histories_ends");
  const auto run = run_keyblock({"run", folder + "/case.json", "-o", folder + "/out", "--set", "motion=static",
                                 "--history", "line:0,1,1,1", "--history", "wide=line:-1,1,2,1"});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  std::vector<double> forces;
  for (const auto& row : rows_of(folder + "/out/histories.csv"))
    if (row.size() > 5 && row[0] == "20" && row[4] == "force_y") forces.push_back(std::stod(row[5]));
  ASSERT_EQ(forces.size(), 2U);
  EXPECT_NEAR(forces[0], 2 * 2500 * 9.81, 1e-5 * forces[0]);
  EXPECT_NEAR(forces[1], forces[0], 1e-9 * forces[0]);
}

TEST(HistoriesCommand, what_cannot_be_followed_is_refused_before_anything_is_written) {
  const std::string folder = case_in("histories_wrong");
  const auto refused = [&](const std::string& history) {
    return run_keyblock({"run", folder + "/case.json", "-o", folder + "/out", "--history", history});
  };
  const auto word = refused("blok:1");
  EXPECT_EQ(word.exit_code, 2);
  EXPECT_TRUE(contains(word.messages, "did you mean \"block\"?")) << word.messages;
  EXPECT_EQ(refused("block:9").exit_code, 3);
  EXPECT_TRUE(contains(refused("block:9").messages,
                       "--history block:9: error: expected the number of a block in a history, 1 to 3, found 9"));
  EXPECT_TRUE(contains(refused("bolt:crown").messages, "bolts have numbers here, names in the case file"));
  EXPECT_EQ(refused("joint:9").exit_code, 3);
  EXPECT_TRUE(contains(refused("point:7,7").messages, "found 7, 7 in none")) << refused("point:7,7").messages;
  EXPECT_FALSE(std::filesystem::exists(folder + "/out"));
  const std::string two = case_in("histories_two", R"(, "outputs": {"histories": [{"block": 1, "joint": 5}]})");
  EXPECT_TRUE(contains(run_keyblock({"check", two + "/case.json"}).messages,
                       "expected one of point, block, contact, joint, line and bolt in a history, found 2"));
}

TEST(HistoriesCommand, two_items_of_one_name_are_refused_and_one_given_twice_counts_once) {
  const std::string folder = case_in("histories_named", R"(, "outputs": {"histories": [{"block": 2}]})");
  const auto followed = [&](const std::string& history) {
    return run_keyblock(
        {"run", folder + "/case.json", "-o", folder + "/out", "--force", "--history", "block:3", "--history", history});
  };
  for (const auto& [history, two] : std::vector<std::pair<std::string, std::string>>{
           {"3=block:1", "block 3 and block 1"}, {"2=point:0.5,2.5", "block 2 and point 0.5 2.5"}}) {
    const auto run = followed(history);
    EXPECT_EQ(run.exit_code, 3) << history;
    EXPECT_TRUE(contains(run.messages, "--history " + history + ": error: expected a name of its own for each history"))
        << run.messages;
    EXPECT_TRUE(contains(run.messages, two)) << run.messages;
  }
  EXPECT_TRUE(contains(followed("ledger=block:1").messages,
                       "error: expected another name of a history, found \"ledger\", which names the energy balance"));
  ASSERT_EQ(followed("second=block:2").exit_code, 0);
  const std::size_t lines = lines_of(folder + "/out/histories.csv");
  EXPECT_EQ(followed("block:2").exit_code, 0);
  EXPECT_EQ(lines_of(folder + "/out/histories.csv") - 1, (lines - 1) / 3 * 2);
  const auto apart = followed("joint:2");  // beside block 2
  EXPECT_EQ(apart.exit_code, 0) << apart.messages;
  EXPECT_TRUE(contains(support::read_text(folder + "/out/histories.csv"), ",joint,joint 2,"));
}

// Two stages; the second cuts the upper block in two: four blocks in all, and a fifth in neither.
TEST(HistoriesCommand, blocks_that_a_stage_makes_are_followed_and_those_that_none_makes_refused) {
  const std::string folder = case_in("histories_stages", R"(, "stages": [{"steps": 3},
      {"steps": 3, "cuts": [[-9, 2.4, 9, 2.5, 1]]}])");
  const auto followed = [&](const std::string& history) {
    return run_keyblock({"run", folder + "/case.json", "-o", folder + "/out", "--force", "--history", history});
  };
  EXPECT_EQ(followed("block:4").exit_code, 0) << followed("block:4").messages;
  const auto fifth = followed("block:5");
  EXPECT_EQ(fifth.exit_code, 3);
  EXPECT_TRUE(contains(fifth.messages, "1 to 4, found 5")) << fifth.messages;
}

TEST(HistoriesCommand, a_run_that_was_killed_ends_with_the_same_histories) {
  const std::string folder = case_in("histories_killed");
  const auto runs = support::killed_runs({folder + "/case.json", "--set", "steps=300", "--history", "block:3",
                                          "--history", "line:-1,1,2,1", "--contacts", "3"},
                                         2, 1);
  EXPECT_EQ(runs.differs, "");
}

TEST(HistoriesCommand, contacts_name_the_joint_of_the_drawing_and_are_summed_by_it) {
  const std::string folder = case_in("joint_lines");
  const std::string out = folder + "/out";
  ASSERT_EQ(run_keyblock({"run", folder + "/case.json", "-o", out}).exit_code, 0);
  const auto contacts = rows_of(out + "/contacts.csv");
  ASSERT_EQ(contacts[0][5], "joint");
  for (std::size_t i = 1; i < contacts.size(); ++i)
    EXPECT_EQ(contacts[i][5], std::stod(contacts[i][8]) > 1.5 ? "6" : "5") << "y of the contact decides";
  const auto joints = rows_of(out + "/joint_lines.csv");
  EXPECT_EQ(joints[0][2], "joint");
  EXPECT_EQ(joints.back()[2], "6");
  EXPECT_NEAR(std::stod(joints.back()[7]) / kWeight, 1, 1e-6);
  EXPECT_NEAR(std::stod(joints[joints.size() - 2][7]) / (2 * kWeight), 1, 1e-6);
  EXPECT_TRUE(contains(read_text(out + "/frames/contacts_00000020.vtp"), "Name=\"joint\""));
}

TEST(HistoriesCommand, contacts_are_written_as_asked) {
  const std::string folder = case_in("contact_tables");
  const auto run_with = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> all{"run", folder + "/case.json", "-o", folder + "/" + name, "--record-every", "1"};
    all.insert(all.end(), more.begin(), more.end());
    return run_keyblock(all);
  };
  ASSERT_EQ(run_with("all", {}).exit_code, 0);
  ASSERT_EQ(run_with("none", {"--contacts", "none"}).exit_code, 0);
  ASSERT_EQ(run_with("tenth", {"--contacts", "10"}).exit_code, 0);
  ASSERT_EQ(run_with("chosen", {"--contacts", "chosen", "--history", "joint:6"}).exit_code, 0);
  EXPECT_EQ(lines_of(folder + "/all/contacts.csv"), 1U + 21 * 4);
  for (const char* name : {"contacts.csv", "joints.csv", "joint_lines.csv", "frames/contacts_00000020.vtp"}) {
    EXPECT_TRUE(std::filesystem::exists(folder + "/all/" + name)) << name;
    EXPECT_FALSE(std::filesystem::exists(folder + "/none/" + name)) << name;
  }
  EXPECT_EQ(lines_of(folder + "/tenth/contacts.csv"), 1U + 3 * 4) << "frames 0, 10 and 20";
  EXPECT_EQ(lines_of(folder + "/chosen/contacts.csv"), 1U + 21 * 2);
  EXPECT_EQ(read_text(folder + "/chosen/joints.csv"), read_text(folder + "/all/joints.csv")) << "sums are of all";
  const auto nothing = run_with("nothing", {"--contacts", "chosen"});
  EXPECT_EQ(nothing.exit_code, 3);
  EXPECT_TRUE(
      contains(nothing.messages,
               "--contacts chosen: error: expected a history of a block, a contact or a joint for chosen contacts"))
      << nothing.messages;
  const auto wrong = run_with("wrong", {"--contacts", "most"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(contains(wrong.messages, "found \"most\"")) << wrong.messages;
}

}  // namespace keyblock::histories_command_test
