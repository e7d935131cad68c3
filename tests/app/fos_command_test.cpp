// `fos` and `run --reduce-strength` from the command line: brackets, files, exit codes, bad input.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "base/bytes/sha256.hpp"
#include "formats/registry.hpp"
#include "formats/text/csv.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::fos_command_test {
namespace {

using support::fresh_folder;
using support::ProgramRun;
using support::read_text;
using support::run_keyblock;
using support::write_text;
using Json = nlohmann::json;

const std::string kCases = KEYBLOCK_SOURCE_DIR "/legacy_cases/";
const std::string kBlock = kCases + "strength_reduction/block_on_plane";

double tangent(double degrees) {
  return std::tan(degrees * std::numbers::pi / 180);
}

/// A square of rock under its weight on a smooth floor.
std::string square(const std::string& strength) {
  return R"({"keyblock": 1, "blocks": {"blocks": [{"outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]}]},
    "covers": {"mesh": {"kind": "unstructured", "placement": "aligned", "side": 0.4},
    "displacements": [{"along": [[0, 0], [1, 0]], "held": "y"}, {"along": [[0, 0], [0, 1]], "held": "x"}],
    "tractions": [{"along": [[0, 1], [1, 1]], "y": -10}]}, "analysis": {"step_count": 4, "time_step": 1,
    "allowed_displacement_ratio": 0.1, "plane_strain": true, "velocity_carry_over": 0, "joint_materials": [{}],
    "block_materials": [{"density": 1, "unit_weight": 0, "youngs_modulus": 1e6, "poissons_ratio": 0.3)" +
         strength + "}]}}";
}

std::string written(const std::string& name, const std::string& text) {
  const std::string file = fresh_folder("fos_" + name) + "/in.json";
  write_text(file, text);
  return file;
}

/// A square of this size in the air, then a fixed plane of 30 degrees and a block of 2 by 1 on it, with 40 degrees of
/// friction. The last two have points, which follow their blocks if the square is left out.
std::string square_above_a_block(double size) {
  return fmt::format(R"({{"keyblock": 2, "units": {{"length": "m", "mass": "kg", "time": "s"}}, "blocks": {{"blocks": [
    {{"outer": [[8, 6, 1], [{0}, 6, 1], [{0}, {1}, 1], [8, {1}, 1]]}},
    {{"outer": [[0, 0, 1], [10, 0, 1], [0, 5.773502691896258, 1]]}},
    {{"outer": [[2.598076211353316, 4.273502691896258, 1], [4.330127018922194, 3.273502691896258, 1],
               [4.830127018922194, 4.139528095680697, 1], [3.098076211353316, 5.139528095680697, 1]]}}],
    "fixed_points": [[1, 1, 2], [8, 0.5, 2]], "measured_points": [[3.7, 4.2, 3]]}},
    "analysis": {{"step_count": 1, "time_step": 0.01, "gravity": 9.81,
    "block_materials": [{{"density": 2500, "youngs_modulus": 5e9, "poissons_ratio": 0.25}}],
    "joint_materials": [{{"friction_angle_deg": 40}}]}}}})",
                     8 + size, 6 + size);
}

/// A fixed plane and two blocks of 1 by 1 on it, 2 and 6 along the slope, with friction of their own, all in degrees.
std::string block_on_plane(double plane, double lower_friction, double upper_friction) {
  const double c = std::cos(plane * std::numbers::pi / 180), s = std::sin(plane * std::numbers::pi / 180);
  const auto block = [&](double left, double right, double low, double high, int joint) {
    const auto corner = [&](double along, double across) {
      return fmt::format("[{}, {}, {}]", along * c - across * s, along * s + across * c, joint);
    };
    return fmt::format(R"({{"outer": [{}, {}, {}, {}]}})", corner(left, low), corner(right, low), corner(right, high),
                       corner(left, high));
  };
  return fmt::format(R"({{"keyblock": 2, "units": {{"length": "m", "mass": "kg", "time": "s"}}, "blocks": {{"blocks": [
    {}, {}, {}, {}], "fixed_points": [[{}, {}, 1], [{}, {}, 1], [{}, {}, 2], [{}, {}, 2]]}},
    "analysis": {{"step_count": 1, "time_step": 0.01, "gravity": 9.81,
    "block_materials": [{{"density": 2500, "youngs_modulus": 5e9, "poissons_ratio": 0.25}}],
    "joint_materials": [{{"friction_angle_deg": {}}}, {{"friction_angle_deg": {}}}]}}}})",
                     block(0, 4.5, -1, 0, 1), block(4.5, 9, -1, 0, 2), block(2, 3, 0, 1, 1), block(6, 7, 0, 1, 2),
                     c + 0.5 * s, s - 0.5 * c, 4 * c + 0.5 * s, 4 * s - 0.5 * c, 5 * c + 0.5 * s, 5 * s - 0.5 * c,
                     8 * c + 0.5 * s, 8 * s - 0.5 * c, lower_friction, upper_friction);
}

}  // namespace

// The square has no support: it falls at any factor, and must not hide the factor of the block. Its area is 4e-4 of 31.
TEST(FosCommand, a_loose_sliver_is_left_out_and_named) {
  const ProgramRun run = run_keyblock({"fos", written("sliver", square_above_a_block(0.02)), "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  const Json found = Json::parse(run.output);
  EXPECT_NEAR(found["factor_of_safety"].get<double>(), tangent(40) / tangent(30), 0.01);
  EXPECT_EQ(found["left_out"], Json::array({1}));
  EXPECT_NE(found["notes"].dump().find("block 1 at 8.01, 6.01 has no support and is small"), std::string::npos)
      << found["notes"];
  EXPECT_NE(run.messages.find("[unheld_blocks]"), std::string::npos) << "fos warns as check does: " << run.messages;
  EXPECT_NE(run.messages.find("[slivers]"), std::string::npos) << run.messages;
}

TEST(FosCommand, a_slope_that_nothing_fixes_ends_before_any_trial) {
  const std::string folder = fresh_folder("fos_loose"), file = folder + "/slope.json";
  run_keyblock({"new", "slope", "-o", file});
  std::string text = read_text(file);
  const std::size_t from = text.find("\"fixed_lines\"");
  text.erase(from, text.find('\n', from) - from);
  write_text(file, text);
  const ProgramRun run = run_keyblock({"fos", file, "-o", folder + "/out"});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_NE(run.messages.find("nothing fixes the blocks"), std::string::npos) << run.messages;
  EXPECT_EQ(run.messages.find("F = "), std::string::npos) << run.messages;
  EXPECT_FALSE(std::filesystem::exists(folder + "/out"));
}

// Two blocks that fly towards one another: no weight, no load, nothing fixed.
TEST(FosCommand, blocks_without_support_and_load_end_before_any_trial) {
  const ProgramRun run = run_keyblock({"fos", KEYBLOCK_SOURCE_DIR "/legacy_cases/two_body_impact/row_1"});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_NE(run.messages.find("nothing fixes the blocks, and no load acts on them"), std::string::npos) << run.messages;
  EXPECT_EQ(run.messages.find("F = "), std::string::npos) << run.messages;
}

// Less than a hundredth of the mean area, yet 0.29 % of the whole: its fall is that of the scene.
TEST(FosCommand, what_is_not_small_is_not_left_out) {
  const ProgramRun run = run_keyblock({"fos", written("square", square_above_a_block(0.3)), "--from", "1", "--json"});
  EXPECT_EQ(run.exit_code, 1) << run.messages;
  const Json found = Json::parse(run.output);
  EXPECT_EQ(found["end"], "falls");
  EXPECT_EQ(found["left_out"], Json::array());
}

// The body on a circle slides by 0.17 of its height until its toe stops it, and is in equilibrium there. At factors
// reported as stable it has not slid, from any start of the search.
TEST(FosCommand, a_case_that_has_slid_does_not_stand) {
  const std::string circle = KEYBLOCK_SOURCE_DIR "/legacy_cases/circle_slope/circle_slope";
  double factor = 0;
  for (const char* from : {"1", "0.1"}) {
    std::vector<std::string> words{"fos", circle + ".geo", circle + ".ana", "--json"};
    if (from != std::string("1")) words.insert(words.end(), {"--from", from});
    const ProgramRun run = run_keyblock(words);
    EXPECT_EQ(run.exit_code, 1) << "below 1: " << run.messages;
    const Json found = Json::parse(run.output);
    for (const Json& trial : found["trials"])
      if (trial["verdict"] == "stands") {
        EXPECT_LT(trial["largest_displacement"], 0.01) << from << ": " << trial;
      }
    ASSERT_TRUE(found["bracket"]["stands"].is_number()) << found;
    const double stands = found["bracket"]["stands"];
    if (factor > 0) {
      EXPECT_NEAR(stands, factor, 0.02);
    }
    factor = stands;
  }
}

TEST(FosCommand, brackets_a_block_on_a_plane) {
  const ProgramRun run = run_keyblock({"fos", kBlock, "--json", "--to-within", "1e-3"});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  const Json found = Json::parse(run.output);
  const double exact = tangent(40) / tangent(30);
  EXPECT_LE(found["bracket"]["stands"], exact);
  EXPECT_GE(found["bracket"]["falls"], exact);
  EXPECT_NEAR(found["factor_of_safety"].get<double>(), exact, 1e-3 * exact);
  EXPECT_EQ(found["reduced"], "joints");
  EXPECT_FALSE(found["lower_estimate"]);
  EXPECT_EQ(run_keyblock({"fos", kBlock, "--json", "--to-within", "1e-3"}).output, run.output);
}

TEST(FosCommand, writes_its_trials_and_pictures_and_overwrites_nothing) {
  const std::string out = fresh_folder("fos_files") + "/out";
  const std::vector<std::string> command{"fos", kBlock, "-o", out, "--json"};
  const ProgramRun run = run_keyblock(command);
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  const Json record = Json::parse(read_text(out + "/fos.json"));
  EXPECT_EQ(record, Json::parse(run.output));
  EXPECT_EQ(formats::read_csv(formats::load(out + "/trials.csv")).rows.size(), record["trials"].size());
  EXPECT_NE(read_text(out + "/picture.svg").find("unstable at F"), std::string::npos);
  EXPECT_NE(read_text(out + "/picture.svg").find("<title>slip"), std::string::npos);
  EXPECT_NE(read_text(out + "/fos.svg").find("unstable from"), std::string::npos);
  EXPECT_EQ(run_keyblock(command).exit_code, 2);
}

TEST(FosCommand, the_record_names_units_inputs_and_changed_values) {
  const std::string folder = fresh_folder("fos_origin");
  write_text(folder + "/in.json", square_above_a_block(8.5));
  run_keyblock({"fos", folder + "/in.json", "-o", folder + "/out", "--at", "/analysis/gravity=9.5"});
  const Json record = Json::parse(read_text(folder + "/out/fos.json"));
  EXPECT_EQ(record["units"]["length"], "m");
  EXPECT_EQ(record["inputs"][0]["file"], folder + "/in.json");
  EXPECT_EQ(record["inputs"][0]["sha256"], sha256(read_text(folder + "/in.json")));
  EXPECT_EQ(record["values"], Json({{"/analysis/gravity", 9.5}}));
  EXPECT_EQ(record["outputs"][1], "trials.csv");
}

TEST(FosCommand, run_reduces_strength_too) {
  const std::string out = fresh_folder("fos_run") + "/out";
  const ProgramRun run = run_keyblock({"run", kBlock, "--reduce-strength", "joints", "-o", out, "--to-within", "0.05"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_NE(run.output.find("factor of safety"), std::string::npos) << run.output;
  EXPECT_TRUE(std::filesystem::exists(out + "/fos.json"));
  EXPECT_FALSE(std::filesystem::exists(out + "/run.json"));
}

// Friction of 20 degrees on a plane of 30.
TEST(FosCommand, what_falls_at_1_is_exit_1_and_is_told_how_strong_it_would_have_to_be) {
  const std::string slope = kCases + "sliding_block/a30_p20/a30_p20";
  const ProgramRun run = run_keyblock({"fos", slope + ".geo", slope + ".ana", "--json"});
  EXPECT_EQ(run.exit_code, 1);
  const double exact = tangent(20) / tangent(30);
  const Json found = Json::parse(run.output);
  EXPECT_NEAR(found["factor_of_safety"].get<double>(), exact, 0.01);
  const std::string out = fresh_folder("fos_falls") + "/out";
  const ProgramRun from = run_keyblock({"fos", slope + ".geo", slope + ".ana", "--from", "1", "-o", out});
  EXPECT_EQ(from.exit_code, 1);
  EXPECT_NE(from.output.find("no bracket: unstable at 1"), std::string::npos) << from.output;
  const std::string picture = read_text(out + "/picture.svg");
  EXPECT_NE(picture.find("as drawn"), std::string::npos);
  EXPECT_NE(picture.find("<title>slip"), std::string::npos) << "the unstable blocks are shown beside the drawing";
}

TEST(FosCommand, no_bracket_up_to_the_limit_is_exit_1) {
  const ProgramRun run = run_keyblock({"fos", kBlock, "--to", "1.2"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.output.find("stable at 1.2"), std::string::npos) << run.output;
}

// Uniaxial strength 2 c tan(45 + φ/2) over the traction 10, under a factor on c and tan φ:
// 2 (c/F) (tan φ/F + √(1 + tan² φ/F²)) = 10.
TEST(FosCommand, rock_is_reduced_in_cohesion_and_friction) {
  const std::string file =
      written("rock", square(R"(, "strength": {"cohesion": 10, "friction_deg": 20, "dilation_deg": 20})"));
  double low = 1, high = 10;
  for (int i = 0; i < 60; ++i) {
    const double f = (low + high) / 2, t = tangent(20) / f;
    (2 * 10 / f * (t + std::sqrt(1 + t * t)) > 10 ? low : high) = f;
  }
  const ProgramRun run = run_keyblock({"fos", file, "--reduce", "rock", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_NEAR(Json::parse(run.output)["factor_of_safety"].get<double>(), low, 0.01 * low);
  EXPECT_FALSE(Json::parse(run.output)["lower_estimate"]);
}

TEST(FosCommand, flow_below_friction_makes_a_lower_estimate) {
  const std::string file =
      written("lower", square(R"(, "strength": {"cohesion": 10, "friction_deg": 20, "dilation_deg": 5})"));
  const ProgramRun json = run_keyblock({"fos", file, "--reduce", "rock", "--to-within", "0.2", "--json"});
  EXPECT_TRUE(Json::parse(json.output)["lower_estimate"]);
  const ProgramRun words = run_keyblock({"fos", file, "--reduce", "rock", "--to-within", "0.2"});
  EXPECT_NE(words.output.find("a lower estimate"), std::string::npos) << words.output;
}

TEST(FosCommand, what_cannot_be_reduced_is_exit_3_and_writes_nothing) {
  const std::string out = fresh_folder("fos_refused") + "/out";
  const std::string elastic = written("elastic", square(""));
  for (const char* what : {"rock", "joints", "both"}) {
    const ProgramRun run = run_keyblock({"fos", elastic, "--reduce", what, "-o", out});
    EXPECT_EQ(run.exit_code, 3) << what;
    EXPECT_NE(run.messages.find("which is to be reduced, found none"), std::string::npos) << run.messages;
  }
  const std::string rock = written("untouched", square(R"(, "strength": {"surface": "tresca", "cohesion": 10})"));
  std::string with_joints = read_text(rock);
  with_joints.replace(with_joints.find("[{}]"), 4, R"([{"friction_angle_deg": 30}])");
  const ProgramRun untouched = run_keyblock({"fos", written("friction", with_joints), "-o", out});
  EXPECT_EQ(untouched.exit_code, 3);
  EXPECT_NE(untouched.messages.find("expected bodies in contact"), std::string::npos) << untouched.messages;
  const ProgramRun legacy = run_keyblock({"fos", kCases + "plane_failure/no_crack_stands", "--profile", "legacy"});
  EXPECT_EQ(legacy.exit_code, 3);
  EXPECT_NE(legacy.messages.find("found legacy"), std::string::npos) << legacy.messages;
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(FosCommand, wrong_options_are_exit_2) {
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--reduce", "bolts"},
                                                {"--from", "0"},
                                                {"--from", "2", "--to", "1.5"},
                                                {"--to", "0.5"},
                                                {"--to-within", "-1"},
                                                {"--set", "no_such=1"}}) {
    std::vector<std::string> command{"fos", kBlock};
    command.insert(command.end(), wrong.begin(), wrong.end());
    EXPECT_EQ(run_keyblock(command).exit_code, 2) << wrong.back();
  }
  EXPECT_EQ(run_keyblock({"run", kBlock, "--to", "2"}).exit_code, 2);
  EXPECT_EQ(run_keyblock({"fos"}).exit_code, 2);
}

// Rigid columns on a stepped base (Goodman & Bray 1976): tan φ over the critical 0.78554. The recursion takes friction
// as fully mobilised everywhere; 5 % is the tolerance of legacy_cases/goodman_bray in angles.
TEST(FosCommand, columns_that_topple_keep_to_their_recursion) {
  const ProgramRun run = run_keyblock({"fos", kCases + "goodman_bray/stands", "--json", "--to-within", "0.005"});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  const double exact = tangent(39.6512) / 0.78554;
  EXPECT_NEAR(Json::parse(run.output)["factor_of_safety"].get<double>(), exact, 0.05 * exact);
}

// `run` keeps the square, but reports it; of a large square it reports nothing.
TEST(FosCommand, statics_of_a_run_says_where_a_sliver_alone_falls) {
  for (const auto& [size, is_told] : {std::pair{0.02, true}, std::pair{2.0, false}}) {
    const std::string file = written("sliver", square_above_a_block(size));
    const ProgramRun run = run_keyblock(
        {"run", file, "-o", std::filesystem::path(file).replace_filename("out").string(), "--set", "motion=static"});
    EXPECT_EQ(run.exit_code, 4) << run.messages;
    const bool is_there = run.messages.find("only slivers move (block 1)") != std::string::npos;
    EXPECT_EQ(is_there, is_told) << run.messages;
  }
}

// A jointed slope takes more than two linear solves: its first trial is given up without a result. The verdict is the
// same on a busy machine.
TEST(FosCommand, a_trial_beyond_its_limit_is_given_up_and_the_bracket_told_as_it_is_known) {
  const std::string folder = fresh_folder("fos_limit");
  ASSERT_EQ(run_keyblock({"new", "slope", "-o", folder + "/slope.json"}).exit_code, 0);
  const ProgramRun run = run_keyblock({"fos", folder + "/slope.json", "--trial-limit", "2", "--json"});
  EXPECT_EQ(run.exit_code, 1) << run.messages;
  const Json found = Json::parse(run.output);
  EXPECT_EQ(found["end"], "undecided");
  EXPECT_TRUE(found["factor_of_safety"].is_null());
  EXPECT_TRUE(found["bracket"]["stands"].is_null());
  ASSERT_EQ(found["trials"].size(), 1U);
  EXPECT_EQ(found["trials"][0]["verdict"], "undecided");
  EXPECT_EQ(found["trials"][0]["systems"], 2);
  EXPECT_EQ(found["trials"][0]["why"], "given up after 2 linear solves (--trial-limit)");
  const std::string note = found["notes"].back();
  EXPECT_EQ(note.substr(0, 28), "statics does not decide at 1") << note;
  EXPECT_TRUE(note.ends_with("nothing is known")) << note;
}

// The limit counts linear solves, not seconds.
TEST(FosCommand, a_limit_in_seconds_is_refused_with_the_reason) {
  for (const char* limit : {"60s", "0.5", "-1"}) {
    const ProgramRun run = run_keyblock({"fos", kBlock, "--trial-limit", limit});
    EXPECT_EQ(run.exit_code, 2) << limit;
    EXPECT_NE(run.messages.find("linear solves"), std::string::npos) << run.messages;
    EXPECT_NE(run.messages.find("not in seconds"), std::string::npos) << run.messages;
  }
}

TEST(FosCommand, a_trial_without_limit_is_no_fault) {
  const std::string folder = fresh_folder("fos_no_limit");
  ASSERT_EQ(run_keyblock({"new", "slope", "-o", folder + "/slope.json"}).exit_code, 0);
  const ProgramRun run = run_keyblock({"fos", folder + "/slope.json", "--trial-limit", "0", "--to-within", "0.2"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
}

// Friction of 2 degrees on a plane of 40: F = tan 2 / tan 40 = 0.0416, below all factors tried by default.
TEST(FosCommand, what_falls_at_every_factor_tried_names_the_option_that_goes_lower) {
  const std::string file = written("lower", block_on_plane(40, 2, 2));
  const ProgramRun falls = run_keyblock({"fos", file});
  EXPECT_EQ(falls.exit_code, 1);
  EXPECT_NE(falls.output.find("the least factor tried; --from 0.00"), std::string::npos) << falls.output;
  const ProgramRun from = run_keyblock({"fos", file, "--from", "0.02", "--to-within", "0.001", "--json"});
  EXPECT_NEAR(Json::parse(from.output)["factor_of_safety"].get<double>(), tangent(2) / tangent(40), 0.001)
      << from.output;
}

// Two blocks on a plane of 30 degrees: the lower with 20 degrees of friction, the upper with 40. An exempt block keeps
// its 40 degrees while the other slides, selected by its material or by its place; else both follow tan 20 / tan 30.
TEST(FosCommand, what_is_exempt_keeps_its_strength) {
  const std::string file = written("exempt", block_on_plane(30, 45, 40));
  const auto factor = [&](const std::vector<std::string>& exempt) {
    std::vector<std::string> words{"fos", file, "--json", "--to-within", "0.002"};
    for (const std::string& word : exempt) words.insert(words.end(), {"--exempt", word});
    const ProgramRun run = run_keyblock(words);
    EXPECT_EQ(run.exit_code, 0) << run.messages << run.output;
    const Json found = Json::parse(run.output);
    EXPECT_EQ(found["exempt"].size(), exempt.size());
    EXPECT_EQ(found["notes"].dump().find("exempt from reduction") != std::string::npos, !exempt.empty());
    return found["factor_of_safety"].get<double>();
  };
  const double lower = tangent(45) / tangent(30), upper = tangent(40) / tangent(30);
  EXPECT_NEAR(factor({}), upper, 0.002);
  EXPECT_NEAR(factor({"joint_material:2"}), lower, 0.002);
  EXPECT_NEAR(factor({"box:5,2.8,9,9"}), lower, 0.002) << "the block with 40 degrees lies in it";
  EXPECT_NEAR(factor({"polygon:5,2.8,9,2.8,9,9,5,9"}), lower, 0.002);
}

// Elements of an NMM body in the region: each carries its load of factor 1 at any reduction of the others. The lower
// half leaves the factor of the upper one.
TEST(FosCommand, elements_of_a_body_can_be_exempt) {
  const std::string file =
      written("exempt_rock", square(R"(, "strength": {"cohesion": 10, "friction_deg": 20, "dilation_deg": 20})"));
  const auto found = [&](const std::vector<std::string>& exempt) {
    std::vector<std::string> words{"fos", file, "--reduce", "rock", "--json", "--to-within", "0.02", "--no-mesh-error"};
    words.insert(words.end(), exempt.begin(), exempt.end());
    return Json::parse(run_keyblock(words).output);
  };
  const Json all = found({"--exempt", "box:-1,-1,2,2"});
  EXPECT_EQ(all["end"], "stands") << all;
  const double plain = found({})["factor_of_safety"].get<double>();
  EXPECT_NEAR(found({"--exempt", "box:-1,-1,2,0.3"})["factor_of_safety"].get<double>(), plain, 0.1 * plain);
}

TEST(FosCommand, exempt_words_that_name_nothing_are_refused) {
  const std::string file = written("exempt_nothing", block_on_plane(30, 45, 40));
  for (const char* word : {"material", "material:0", "material:1.5", "box:1,2,3", "box:1,1,1,2", "region:1",
                           "polygon:1,2", "box:a,b,c,d", "box:100,100,101,101"})
    EXPECT_EQ(run_keyblock({"fos", file, "--exempt", word}).exit_code, 2) << word;
  EXPECT_EQ(run_keyblock({"fos", file, "--exempt", "joint_material:3"}).exit_code, 3) << "there are two";
  const ProgramRun all = run_keyblock({"fos", file, "--exempt", "joint_material:1", "--exempt", "joint_material:2"});
  EXPECT_EQ(all.exit_code, 3);
  EXPECT_NE(all.messages.find("found none that is not exempt"), std::string::npos) << all.messages;
}

}  // namespace keyblock::fos_command_test
