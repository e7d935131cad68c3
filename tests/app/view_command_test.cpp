// `keyblock view` and `run --page`: one page with the frames, tables and stages of a run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "formats/registry.hpp"
#include "formats/views/vtk_piece.hpp"
#include "formats/views/vtu_reading.hpp"
#include "tests/support/page_reading.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::view_command_test {
namespace {

using support::contains;
using support::fresh_folder;
using support::ProgramRun;
using support::read_text;
using support::ReadPage;
using support::run_keyblock;
using support::write_text;

/// Two blocks on a fixed one; an excavation cuts the upper one to half: all counts stay.
constexpr const char* kCutLater = R"({"keyblock": 2, "units": {"length": "m", "mass": "kg", "time": "s"},
 "blocks": {"blocks": [{"material": "<b>rock", "outer": [[0, -1, "j"], [6, -1, "j"], [6, 0, "j"], [0, 0, "j"]]},
   {"material": "<b>rock", "outer": [[1, 0, "j"], [5, 0, "j"], [5, 1, "j"], [1, 1, "j"]]},
   {"material": "<b>rock", "outer": [[1, 1, "j"], [5, 1, "j"], [5, 3, "j"], [1, 3, "j"]]}],
  "fixed_points": [[0.5, -0.5, 1], [5.5, -0.5, 1]], "measured_points": [[2, 0.5, 2]]},
 "stages": [{"name": "before", "steps": 4},
   {"name": "cut </script>", "steps": 4, "excavations": [{"outline": [[0, 2], [6, 2], [6, 4], [0, 4]]}]}],
 "analysis": {"step_count": 8, "time_step": 0.001, "gravity": 9.81,
  "block_materials": [{"name": "<b>rock", "like": "sandstone"}],
  "joint_materials": [{"name": "j", "friction_angle_deg": 30}]}})";

struct Viewed {
  std::string out;
  ReadPage page;
};

Viewed viewed(const std::string& name, const std::vector<std::string>& more = {}) {
  const std::string folder = fresh_folder(name);
  write_text(folder + "/case.json", kCutLater);
  std::vector<std::string> words{"run", folder + "/case.json", "-o", folder + "/out", "--record-every", "2", "--page"};
  words.insert(words.end(), more.begin(), more.end());
  const ProgramRun run = run_keyblock(words);
  EXPECT_LE(run.exit_code, 1) << run.messages;
  return {folder + "/out", ReadPage(read_text(folder + "/out/page.html"))};
}

formats::VtuFrame frame_of(const std::string& out, int step) {
  return formats::read_vtu(formats::load(fmt::format("{}/frames/{:08}.vtu", out, step)));
}

TEST(ViewCommand, values_are_those_of_the_frames) {
  const auto [out, page] = viewed("view_values");
  const auto& frames = page.head().at("frames");
  ASSERT_GE(frames.size(), 4U);
  for (const std::size_t f : {std::size_t{1}, frames.size() - 1}) {
    const formats::VtuFrame frame = frame_of(out, frames[f].at("step"));
    EXPECT_EQ(frames[f].at("time"), frame.field.time);
    for (std::size_t b = 0; b < frame.numbers.size(); ++b) {
      const FieldCorner& middle = frame.field.elements[b].middle;
      EXPECT_NEAR(page.value("stress", 1, f, b), middle.stress.yy, 5e-4 * std::abs(middle.stress.yy));
      EXPECT_NEAR(page.value("motion", 1, f, b), middle.displacement.y, 4e-5 * std::abs(middle.displacement.y) + 1e-12);
    }
  }
}

TEST(ViewCommand, an_excavation_that_keeps_all_counts_begins_an_epoch) {
  const auto [out, page] = viewed("view_epochs");
  ASSERT_EQ(page.head().at("epochs").size(), 2U);
  EXPECT_EQ(page.head().at("epochs").at(0).at("vertices"), page.head().at("epochs").at(1).at("vertices"));
  EXPECT_NE(page.shape(0).place, page.shape(1).place);
  EXPECT_EQ(page.shape(0).key, page.shape(1).key);
  EXPECT_EQ(page.head().at("frames").front().at("stage"), "before");
  EXPECT_EQ(page.head().at("frames").back().at("stage"), "cut </script>");
}

TEST(ViewCommand, closed_contacts_are_those_of_the_run) {
  const auto [out, page] = viewed("view_contacts");
  const std::size_t last = page.head().at("frames").size() - 1;
  const auto rows = page.rows("contacts", last);
  const formats::Source source = formats::load(
      fmt::format("{}/frames/contacts_{:08}.vtp", out, page.head().at("frames").at(last).at("step").get<int>()));
  const formats::VtkPiece piece(source, "PolyData");
  const auto forces = piece.at("PointData", "normal_force").numbers(),
             states = piece.at("PointData", "state").numbers();
  std::vector<double> closed;
  for (std::size_t i = 0; i < forces.size(); ++i)
    if (states[i] != 0) closed.push_back(forces[i]);
  ASSERT_FALSE(closed.empty());
  ASSERT_EQ(rows.at("normal_force").size(), closed.size());
  for (std::size_t i = 0; i < closed.size(); ++i)
    EXPECT_NEAR(rows.at("normal_force")[i], closed[i], 2e-4 * std::abs(closed[i]));
  for (const double row : rows.at("block")) EXPECT_LT(row, 3);
  for (const double state : rows.at("state")) EXPECT_GE(state, 1);
}

TEST(ViewCommand, names_units_supports_and_curves_are_there) {
  const auto [out, page] = viewed("view_names");
  EXPECT_FALSE(contains(page.text(), "<b>rock"));
  EXPECT_EQ(page.head().at("materials").at(0), "<b>rock");
  EXPECT_EQ(page.head().at("joints").at(0), "j");
  EXPECT_EQ(page.head().at("units").at("stress"), "Pa");
  ASSERT_EQ(page.head().at("still").size(), 2U);
  EXPECT_EQ(page.head().at("still").at(1).at("at").at(0), 5.5 - 3) << "from the middle of the scene";
  std::vector<std::string> names;
  for (const auto& table : page.head().at("tables")) {
    names.push_back(table.at("name"));
    const std::size_t rows = table.at("columns").at(0).at("values").size();
    for (const auto& column : table.at("columns")) EXPECT_EQ(column.at("values").size(), rows) << names.back();
  }
  for (const char* name : {"history.csv", "ledger.csv", "step_table.csv", "points.csv"})
    EXPECT_TRUE(std::ranges::find(names, name) != names.end()) << name;
  EXPECT_EQ(page.rows("points", 0).at("point"), (std::vector<double>{1}));
}

TEST(ViewCommand, view_writes_the_page_that_the_run_wrote) {
  const auto [out, page] = viewed("view_same");
  EXPECT_TRUE(contains(read_text(out + "/run.json"), "\"page.html\""));
  ASSERT_EQ(run_keyblock({"view", out, "-o", out + "/second.html"}).exit_code, 0);
  EXPECT_EQ(read_text(out + "/second.html"), page.text());
}

TEST(ViewCommand, nothing_is_overwritten_unless_told) {
  const auto [out, page] = viewed("view_force", {"--frames", "zlib"});
  write_text(out + "/page.html", "mine");
  EXPECT_EQ(run_keyblock({"view", out}).exit_code, 2);
  EXPECT_EQ(read_text(out + "/page.html"), "mine");
  EXPECT_EQ(run_keyblock({"view", out, "--force"}).exit_code, 0);
  EXPECT_EQ(read_text(out + "/page.html"), page.text());
  const std::string record = read_text(out + "/run.json");
  EXPECT_EQ(run_keyblock({"view", out, "-o", out + "/run.json", "--force"}).exit_code, 2);
  EXPECT_EQ(read_text(out + "/run.json"), record);
}

TEST(ViewCommand, a_run_without_a_record_is_shown) {
  const auto [out, page] = viewed("view_killed");
  std::filesystem::remove(out + "/run.json");
  ASSERT_EQ(run_keyblock({"view", out, "--force"}).exit_code, 0);
  const ReadPage killed(read_text(out + "/page.html"));
  EXPECT_TRUE(killed.head().at("run").is_null());
  EXPECT_EQ(killed.head().at("units").at("stress"), "Pa");
}

TEST(ViewCommand, a_folder_without_frames_is_refused) {
  const std::string empty = fresh_folder("view_empty");
  const ProgramRun none = run_keyblock({"view", empty});
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_TRUE(contains(none.messages, "error: expected the folder of a run, with frames/*.vtu, found none"))
      << none.messages;
  EXPECT_FALSE(std::filesystem::exists(empty + "/page.html"));
}

}  // namespace
TEST(ViewCommand, a_page_of_an_earlier_run_does_not_stay) {
  const std::string folder = fresh_folder("view_stale"), file = folder + "/block.json", out = folder + "/out";
  run_keyblock({"new", "block", "-o", file});
  ASSERT_EQ(run_keyblock({"run", file, "-o", out, "--set", "steps=5"}).exit_code, 0);
  ASSERT_EQ(run_keyblock({"view", out}).exit_code, 0);
  ASSERT_TRUE(std::filesystem::exists(out + "/page.html"));
  ASSERT_EQ(run_keyblock({"run", file, "-o", out, "--set", "steps=6", "--force"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(out + "/page.html"));
  support::write_text(out + "/page.html", "mine");
  run_keyblock({"run", file, "-o", out, "--set", "steps=7", "--force"});
  EXPECT_EQ(support::read_text(out + "/page.html"), "mine");
}

}  // namespace keyblock::view_command_test
