// `keyblock joints` from the command line: file or options, the same bytes for a seed, drawings that can be cut,
// nothing overwritten.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::joints_command_test {
namespace {

using support::fresh_folder;
using support::read_text;
using support::run_keyblock;

const std::vector<std::string> kSlope{"joints",
                                      "--slope",
                                      "height=10,angle=60",
                                      "--set",
                                      "dip=60,spacing=1,trace=5,gap=0.5,scatter=0.1",
                                      "--set",
                                      "dip=140,spacing=1.5,trace=5,gap=0.5,scatter=0.1",
                                      "--tunnel",
                                      "shape=d,width=3,height=3,x=14,y=-1"};

std::vector<std::string> slope_with(const std::vector<std::string>& more) {
  std::vector<std::string> all = kSlope;
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST(JointsCommand, a_seed_gives_the_same_bytes_and_another_seed_others) {
  const std::string folder = fresh_folder("joints_seed");
  for (const auto& [name, seed] : {std::pair{"a", "1"}, {"b", "1"}, {"c", "2"}}) {
    const auto run = run_keyblock(slope_with({"-o", folder + "/" + name, "--seed", seed}));
    ASSERT_EQ(run.exit_code, 0) << run.messages;
  }
  EXPECT_EQ(read_text(folder + "/a"), read_text(folder + "/b"));
  EXPECT_NE(read_text(folder + "/a"), read_text(folder + "/c"));
}

TEST(JointsCommand, base_and_sides_are_fixed_if_requested) {
  const std::string folder = fresh_folder("joints_fixed");
  ASSERT_EQ(run_keyblock(slope_with({"-o", folder + "/loose.json"})).exit_code, 0);
  ASSERT_EQ(run_keyblock(slope_with({"-o", folder + "/fixed.json", "--fix-sides"})).exit_code, 0);
  const auto loose = run_keyblock({"check", folder + "/loose.json"});
  const auto fixed = run_keyblock({"check", folder + "/fixed.json"});
  EXPECT_TRUE(contains(loose.messages + loose.output, "no_fixed_points"));
  EXPECT_FALSE(contains(fixed.messages + fixed.output, "no_fixed_points"));
  EXPECT_TRUE(contains(read_text(folder + "/fixed.json"), "\"fixed_lines\""));
}

TEST(JointsCommand, the_drawing_cuts_into_blocks_from_every_format) {
  const std::string folder = fresh_folder("joints_cut");
  for (const char* name : {"/slope.geo", "/slope.dxf", "/slope.json", "/slope.xml"}) {
    ASSERT_EQ(run_keyblock(slope_with({"-o", folder + name})).exit_code, 0);
    ASSERT_EQ(run_keyblock({"cut", folder + name, "-o", folder + name + ".blk"}).exit_code, 0) << name;
  }
  const std::string blocks = read_text(folder + "/slope.geo.blk");
  for (const char* other : {"/slope.dxf", "/slope.json", "/slope.xml"})
    EXPECT_EQ(blocks, read_text(folder + other + ".blk")) << other;
  EXPECT_TRUE(contains(read_text(folder + "/slope.json"), "\"keyblock\": 1"));
  EXPECT_GT(std::stoi(blocks), 50) << "its first number is that of the blocks";
}

TEST(JointsCommand, a_file_says_the_same_as_options) {
  const std::string folder = fresh_folder("joints_file");
  support::write_text(folder + "/spec.json", R"({
    "slope": {"height": 10, "angle": 60},
    "sets": [{"dip": 60, "spacing": 1, "trace": 5, "gap": 0.5, "scatter": 0.1},
             {"dip": 140, "spacing": 1.5, "trace": 5, "gap": 0.5, "scatter": 0.1}],
    "tunnels": [{"shape": "d", "width": 3, "height": 3, "x": 14, "y": -1}],
    "seed": 8})");
  ASSERT_EQ(run_keyblock({"joints", folder + "/spec.json", "-o", folder + "/a.geo", "--seed", "3"}).exit_code, 0);
  ASSERT_EQ(run_keyblock(slope_with({"-o", folder + "/b.geo", "--seed", "3"})).exit_code, 0);
  EXPECT_EQ(read_text(folder + "/a.geo"), read_text(folder + "/b.geo"));
}

TEST(JointsCommand, the_example_of_the_formats_page_cuts) {
  const std::string folder = fresh_folder("joints_example");
  const std::string page = read_text(KEYBLOCK_SOURCE_DIR "/formats/README.md");
  const std::size_t begin = page.find("{\"slope\"");
  ASSERT_NE(begin, std::string::npos);
  support::write_text(folder + "/spec.json", page.substr(begin, page.find("\n\n", begin) - begin));
  const auto run = run_keyblock({"joints", folder + "/spec.json", "-o", folder + "/a.geo"});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  const auto cut = run_keyblock({"cut", folder + "/a.geo", "--json"});
  EXPECT_EQ(cut.exit_code, 0) << cut.messages;
  EXPECT_FALSE(contains(cut.output, "no_fixed_points") || contains(cut.output, "point_outside_blocks")) << cut.output;
}

TEST(JointsCommand, overwrites_only_when_told_to) {
  const std::string folder = fresh_folder("joints_force");
  support::write_text(folder + "/old.geo", "precious");
  EXPECT_EQ(run_keyblock(slope_with({"-o", folder + "/old.geo"})).exit_code, 2);
  EXPECT_EQ(read_text(folder + "/old.geo"), "precious");
  EXPECT_EQ(run_keyblock(slope_with({"-o", folder + "/old.geo", "--force"})).exit_code, 0);
  EXPECT_NE(read_text(folder + "/old.geo"), "precious");
}

TEST(JointsCommand, what_cannot_be_is_refused_with_the_name_of_the_option_or_the_line_of_the_file) {
  const std::string folder = fresh_folder("joints_faults");
  const auto unknown =
      run_keyblock({"joints", "--rectangle", "width=2,height=2", "--set", "dip=0,spacin=1", "-o", folder + "/x.geo"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_TRUE(contains(unknown.messages, "keyblock: error: --set: expected one of the keys dip, spacing,"))
      << unknown.messages;
  const auto none = run_keyblock({"joints", "-o", folder + "/x.geo"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_EQ(none.messages, "keyblock: error: expected one of rectangle, slope and outline, found none\n");
  support::write_text(folder + "/spec.json", "{\"rectangle\": {\"width\": 2,\n  \"hight\": 3}}");
  const auto file = run_keyblock({"joints", folder + "/spec.json", "-o", folder + "/x.geo"});
  EXPECT_EQ(file.exit_code, 3);
  EXPECT_TRUE(contains(file.messages,
                       "spec.json:2:3: error: expected one of the keys width, height, x, y in the "
                       "rectangle, found \"hight\""))
      << file.messages;
  support::write_text(folder + "/spec.json", "{\"rectangle\": {\"width\": 2, \"height\": 2}}");
  const auto seed = run_keyblock({"joints", folder + "/spec.json", "--seed", "-1", "-o", folder + "/x.geo"});
  EXPECT_EQ(seed.exit_code, 2) << "an option beside a sound file";
  EXPECT_FALSE(std::filesystem::exists(folder + "/x.geo"));
}

}  // namespace keyblock::joints_command_test
