// Messages of commands about a drawing: `--join`, `--unit`, the size of the scene, and the reason for an empty drawing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/formats/dxf_samples.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::drawing_options_test {
namespace {

using support::contains;
using support::run_keyblock;

const std::string kShortJoint =
    R"({"keyblock": 2, "units": {"length": "m", "mass": "kg", "time": "s"},
        "drawing": {"edge_node_ratio": 0.001, "boundary_count": 4, "joints": [
        [0, 0, 10, 0, 1], [10, 0, 10, 10, 1], [10, 10, 0, 10, 1], [0, 10, 0, 0, 1], [0.002, 5, 9.998, 5, 1]],
        "fixed_lines": [[-1, 1, 11, 1]]}, )";
const std::string kAnalysis =
    R"("analysis": {"step_count": 3, "time_step": 0.001, "block_materials": [{"density": 2600, "youngs_modulus": 2e10,
       "poissons_ratio": 0.2}], "joint_materials": [{"friction_angle_deg": 30}]}})";

std::string written(const std::string& name, const std::string& text) {
  const std::string file = support::fresh_folder("drawing_options_of_" + name) + "/" + name;
  support::write_text(file, text);
  return file;
}

std::string square(double side) {
  const std::string s = std::to_string(side);
  return "0\nLWPOLYLINE\n8\nBOUNDARY\n90\n4\n70\n1\n10\n0\n20\n0\n10\n" + s + "\n20\n0\n10\n" + s + "\n20\n" + s +
         "\n10\n0\n20\n" + s + "\n0\nPOINT\n8\nFIXED\n10\n0.1\n20\n0.1\n0\nPOINT\n8\nFIXED\n10\n0.2\n20\n0.1\n";
}

}  // namespace

TEST(DrawingOptions, a_joint_that_ends_short_is_told_with_its_place_and_joined_by_every_command) {
  const std::string file = written("short.json", kShortJoint + kAnalysis);
  const support::ProgramRun cut = run_keyblock({"cut", file, "--json"});
  EXPECT_EQ(nlohmann::json::parse(cut.output)["blocks"], 1);
  EXPECT_TRUE(contains(
      cut.messages,
      "2 ends of lines stop less than 0.0255 short of another line and meet it nowhere, the nearest 0.002 at "))
      << cut.messages;
  EXPECT_EQ(nlohmann::json::parse(run_keyblock({"cut", file, "--json", "--join", "0.003"}).output)["blocks"], 2);
  EXPECT_TRUE(contains(run_keyblock({"check", file, "--join", "0.003"}).output, "ends_joined"));
  const std::string out = support::fresh_folder("drawing_options_run") + "/out";
  const support::ProgramRun run = run_keyblock({"run", file, "--join", "0.003", "-o", out, "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_TRUE(contains(run.messages, "2 blocks")) << run.messages;
  EXPECT_TRUE(contains(run.messages, ", 10 m by 10 m, ")) << run.messages;
}

TEST(DrawingOptions, a_case_file_says_the_same_by_keys) {
  const std::string keys = kShortJoint + R"("join": "3 mm", )";
  EXPECT_EQ(
      nlohmann::json::parse(run_keyblock({"cut", written("keys.json", keys + kAnalysis), "--json"}).output)["blocks"],
      2);
  const std::string drawing = written("square.dxf", formats::dxf_text(square(4000), "9\n$INSUNITS\n70\n6\n"));
  const std::string unit =
      R"({"keyblock": 2, "units": {"length": "m", "mass": "kg", "time": "s"}, "drawing_unit": "mm", )";
  EXPECT_TRUE(
      contains(run_keyblock({"check", drawing, written("unit.json", unit + kAnalysis)}).output, "size: 4 m by 4 m"));
}

TEST(DrawingOptions, the_unit_of_a_drawing_is_overruled_and_its_size_printed) {
  const std::string drawing = written("square.dxf", formats::dxf_text(square(24000), "9\n$INSUNITS\n70\n6\n"));
  const std::string units = R"({"keyblock": 2, "units": {"length": "m", "mass": "kg", "time": "s"}, )";
  const std::string file = written("case.json", units + kAnalysis);
  const std::string as_metres = run_keyblock({"check", drawing, file}).output;
  EXPECT_TRUE(contains(as_metres, "size: 24000 m by 24000 m")) << as_metres;
  EXPECT_TRUE(contains(as_metres, "implausible_size")) << as_metres;
  const std::string as_millimetres = run_keyblock({"check", drawing, file, "--unit", "mm"}).output;
  EXPECT_TRUE(contains(as_millimetres, "size: 24 m by 24 m")) << as_millimetres;
  EXPECT_FALSE(contains(as_millimetres, "implausible_size")) << as_millimetres;
}

TEST(DrawingOptions, a_drawing_of_hidden_layers_alone_says_why_it_is_empty) {
  std::string text = formats::dxf_text(square(4));
  text.insert(text.find("0\nSECTION\n2\nENTITIES"),
              "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n0\nLAYER\n2\nBOUNDARY\n70\n1\n62\n7\n0\nENDTAB\n0\nENDSEC\n");
  const support::ProgramRun run = run_keyblock({"cut", written("hidden.dxf", text)});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_TRUE(contains(run.messages, "found none; 1 entity on layers that are frozen or off is left out: \"BOUNDARY\""))
      << run.messages;
}

TEST(DrawingOptions, options_that_fit_no_input_are_refused) {
  const std::string file = written("case.json", kShortJoint + kAnalysis);
  EXPECT_EQ(run_keyblock({"check", file, "--unit", "mm"}).exit_code, 2);
  EXPECT_EQ(run_keyblock({"check", file, "--unit", "furlong"}).exit_code, 2);
  EXPECT_EQ(run_keyblock({"cut", file, "--join", "-1"}).exit_code, 2);
  const std::string units = R"({"keyblock": 2, "units": {"length": "m", "mass": "kg", "time": "s"}, )";
  EXPECT_EQ(run_keyblock({"check", written("alone.json", units + kAnalysis), "--join", "1"}).exit_code, 2);
}

// The checkpoint keeps the options: the resumed run is the same.
TEST(DrawingOptions, a_run_that_goes_on_joins_again) {
  const std::string file = written("short.json", kShortJoint + kAnalysis);
  const std::string out = support::fresh_folder("drawing_options_resume") + "/out";
  const std::vector<std::string> run{"run", file, "--join", "0.003", "-o", out, "--set", "steps=20000"};
  EXPECT_EQ(support::interrupt_keyblock(run, out + "/frames/00000200.vtu").exit_code, 130);
  const support::ProgramRun again = run_keyblock({"run", "--resume", out});
  EXPECT_EQ(again.exit_code, 0) << again.messages;
  EXPECT_TRUE(contains(again.messages, "2 blocks")) << again.messages;
}

}  // namespace keyblock::drawing_options_test
