// `check` warns of problems before a run: each warning with its numbers, none for a sound scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::look_ahead_test {
namespace {

const std::string kUnits = R"("units": {"length": "m", "mass": "kg", "time": "s"},)";

std::string case_text(const std::string& geometry, const std::string& units = kUnits,
                      const std::string& more = R"("gravity": 9.81,)") {
  return "{\"keyblock\": 1, " + units + geometry +
         R"(, "analysis": {"velocity_carry_over": 1, "step_count": 50, "time_step": 0.001,
             "allowed_displacement_ratio": 0.01, )" +
         more + R"("block_materials": [{"density": 2600, "youngs_modulus": 2e10, "poissons_ratio": 0.2}],
             "joint_materials": [{"friction_angle_deg": 30}]}})";
}

std::string rectangle(double x0, double y0, double x1, double y1) {
  std::string text = R"({"outer": [)";
  const double corners[4][2] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  for (int i = 0; i < 4; ++i)
    text += (i > 0 ? ", [" : "[") + std::to_string(corners[i][0]) + ", " + std::to_string(corners[i][1]) + ", 1]";
  return text + "]}";
}

// Blocks, the first of which has two fixed points.
std::string blocks(const std::vector<std::string>& all) {
  std::string text = R"("blocks": {"blocks": [)";
  for (const std::string& block : all) text += (&block == &all.front() ? "" : ", ") + block;
  return text + R"(], "fixed_points": [[0.5, 0.5, 1], [9.5, 0.5, 1]]})";
}

nlohmann::json check_of(const std::string& text, const std::vector<std::string>& more = {}, int exit_code = 0) {
  const std::string file = support::fresh_folder("look_ahead") + "/case.json";
  support::write_text(file, text);
  std::vector<std::string> arguments{"check", file, "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const support::ProgramRun run = support::run_keyblock(arguments);
  EXPECT_EQ(run.exit_code, exit_code) << run.messages;
  return nlohmann::json::parse(run.output)["case"];
}

/// Returns the sentence of the warning of this name; empty if there is none.
std::string said(const nlohmann::json& report, const std::string& name) {
  for (const auto& warning : report["warnings"])
    if (warning["name"] == name) return warning["sentence"];
  return {};
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::string kMoves = R"("velocity_carry_over": 1)";
const std::string kFloor = rectangle(0, 0, 10, 1);

}  // namespace

TEST(LookAhead, a_sound_case_is_told_its_cost_and_its_smallest_block_alone) {
  const auto report = check_of(case_text(blocks({kFloor, rectangle(4, 1, 6, 3)})));
  EXPECT_TRUE(report["warnings"].empty()) << report["warnings"];
  EXPECT_EQ(report["smallest_block"], "smallest block: 2 at 5, 2, area 4, 57.1 % of the mean");
  EXPECT_EQ(report["size"], "10 m by 3 m");
  EXPECT_EQ(report["cost"]["steps"], 50);
  EXPECT_GT(report["cost"]["steps_tried"], 0);
  EXPECT_GT(report["cost"]["step_seconds"], 0);
  EXPECT_FALSE(check_of(case_text(blocks({kFloor, rectangle(4, 1, 6, 3)})), {"--trial", "0"}).contains("cost"));
}

TEST(LookAhead, slivers_are_counted_and_the_worst_are_named) {
  const auto report =
      check_of(case_text(blocks({kFloor, rectangle(4, 1, 6, 3), rectangle(0, 1, 0.1, 1.1), rectangle(7, 1, 9, 1.02)})));
  const std::string sentence = said(report, "slivers");
  EXPECT_TRUE(contains(sentence, "2 blocks of 4 are slivers")) << sentence;
  EXPECT_TRUE(contains(sentence, "the smallest is block 3 at 0.05, 1.05, area 0.01 ")) << sentence;
  EXPECT_TRUE(contains(sentence, "the thinnest is block 4 at 8, 1.01, 0.02 wide and 2 long")) << sentence;
}

TEST(LookAhead, blocks_that_nothing_holds_are_named) {
  const auto report = check_of(case_text(blocks({kFloor, rectangle(4, 2, 6, 4), rectangle(4, 4, 6, 6)})));
  const std::string sentence = said(report, "unheld_blocks");
  EXPECT_TRUE(contains(sentence, "2 blocks of 3 are connected to no fixed block")) << sentence;
  EXPECT_TRUE(contains(sentence, "first block 2 at 5, 3")) << sentence;
  EXPECT_EQ(said(report, "unsupported_blocks"), "");
}

// Beside a pillar friction alone may support a block; one on the floor is supported.
TEST(LookAhead, blocks_with_nothing_beneath_are_named) {
  const auto report = check_of(
      case_text(blocks({rectangle(0, 0, 10, 1), rectangle(0, 1, 1, 5), rectangle(1, 3, 2, 4), rectangle(4, 1, 5, 2)})));
  const std::string sentence = said(report, "unsupported_blocks");
  EXPECT_TRUE(contains(sentence, "1 block has no support from below")) << sentence;
  EXPECT_TRUE(contains(sentence, "block 3 at 1.5, 3.5")) << sentence;
}

// The keystone is supported by its neighbours through inclined faces.
TEST(LookAhead, a_wedge_between_two_blocks_is_supported) {
  const std::string left = R"({"outer": [[0, 1, 1], [3, 1, 1], [2.5, 3, 1], [0, 3, 1]]})";
  const std::string right = R"({"outer": [[4, 1, 1], [7, 1, 1], [7, 3, 1], [4.5, 3, 1]]})";
  const std::string wedge = R"({"outer": [[3, 1, 1], [4, 1, 1], [4.5, 3, 1], [2.5, 3, 1]]})";
  const auto report = check_of(case_text(blocks({rectangle(0, 0, 10, 1), left, right, wedge})));
  EXPECT_EQ(said(report, "unsupported_blocks"), "");
}

TEST(LookAhead, a_beam_of_one_block_is_told_that_it_cannot_bend) {
  const auto report =
      check_of(case_text(blocks({kFloor, rectangle(0, 1, 1, 2), rectangle(9, 1, 10, 2), rectangle(0, 2, 10, 3)})));
  const std::string sentence = said(report, "block_cannot_bend");
  EXPECT_TRUE(contains(sentence, "first block 4 at 5, 2.5, 10 long and 0.995 wide")) << sentence;
}

// Two fixed points at one end act as a clamped end, and fix all of the block.
TEST(LookAhead, a_cantilever_of_one_block_is_told_that_it_is_rigid) {
  const auto report = check_of(
      case_text(R"("blocks": {"blocks": [)" + kFloor + R"(], "fixed_points": [[0.1, 0.2, 1], [0.1, 0.8, 1]]})"));
  EXPECT_TRUE(contains(said(report, "block_cannot_bend"), "with two fixed points it is rigid")) << report["warnings"];
}

TEST(LookAhead, points_outside_their_block_are_told) {
  const auto with = [&](const std::string& points) {
    return check_of(
        case_text(R"("blocks": {"blocks": [)" + kFloor + ", " + rectangle(4, 1, 6, 3) + "], " + points + "}"));
  };
  const auto stray = with(R"("fixed_points": [[0.5, 0.5, 1], [90, 0.5, 1]], "measured_points": [[5, 7, 2]])");
  const std::string sentence = said(stray, "point_outside_its_block");
  EXPECT_TRUE(contains(sentence, "2 points lie outside")) << stray["warnings"];
  EXPECT_TRUE(contains(sentence, "the first is a fixed point of block 1 at 90, 0.5, 80 from it")) << sentence;
  const auto sound = with(R"("fixed_points": [[0, 0, 1], [10, 0.5, 1]], "measured_points": [[5, 3, 2]])");
  EXPECT_EQ(said(sound, "point_outside_its_block"), "") << "corners and edges are not outside";
}

// Fixed points that cutting puts inside an edge may lie beyond the other side of a wedge; the file names none of them.
TEST(LookAhead, points_that_cutting_places_are_not_told_of) {
  const auto report = check_of(case_text(R"("drawing": {"edge_node_ratio": 0.001, "boundary_count": 4, "joints": [
      [0, 0, 6, 0, 1], [6, 0, 6, 2, 1], [6, 2, 0, 2, 1], [0, 2, 0, 0, 1], [0.02, 0, 0, 0.02, 1], [3, 0, 3, 2, 1]],
      "fixed_lines": [[-0.1, 0.005, 6.1, 0.005]]})"));
  EXPECT_EQ(report["warnings"].size(), 1u) << report["warnings"];
  EXPECT_NE(said(report, "slivers"), "");
}

// A base line drawn a little inside the outline fixes the end blocks at their far sides, and nowhere else.
TEST(LookAhead, a_fixed_line_that_ends_in_blocks_is_told) {
  const auto with = [&](const std::string& line) {
    return check_of(case_text(R"("drawing": {"edge_node_ratio": 0.001, "boundary_count": 4, "joints": [
        [0, 0, 6, 0, 1], [6, 0, 6, 2, 1], [6, 2, 0, 2, 1], [0, 2, 0, 0, 1], [2, 0, 2, 2, 1], [4, 0, 4, 2, 1]],
        "fixed_lines": [)" + line +
                              "]}"));
  };
  EXPECT_TRUE(contains(said(with("[0.3, 0.3, 5.7, 0.3]"), "fixed_line_ends_in_block"), "2 blocks can rotate"));
  EXPECT_EQ(said(with("[-0.1, 0.3, 6.1, 0.3]"), "fixed_line_ends_in_block"), "") << "beyond the outline";
  EXPECT_EQ(said(with("[0.3, 0.3, 5.7, 0.3], [0.3, 1, 0.3, 1], [5.7, 1, 5.7, 1]"), "fixed_line_ends_in_block"), "");
}

TEST(LookAhead, a_density_that_is_a_unit_weight_is_told) {
  const auto with = [](const std::string& density) {
    std::string text = case_text(blocks({kFloor, rectangle(4, 1, 6, 3)}));
    text.replace(text.find("2600"), 4, density);
    return said(check_of(text), "implausible_density");
  };
  EXPECT_TRUE(contains(with("26"), "as a unit weight in kN/m3 it would be that of rock, whose density is 2650 kg/m3"))
      << with("26");
  EXPECT_NE(with("60"), "");
  EXPECT_NE(with("2.6"), "");
  EXPECT_EQ(with("350"), "") << "pumice";
  EXPECT_EQ(with("7850"), "") << "steel";
}

TEST(LookAhead, a_scene_of_an_implausible_size_is_told) {
  const auto with = [](double scale) {
    const std::string floor = rectangle(0, 0, 10 * scale, scale);
    return said(check_of(case_text(blocks({floor, rectangle(4 * scale, scale, 6 * scale, 3 * scale)}))),
                "implausible_size");
  };
  EXPECT_TRUE(contains(with(1000), "the scene is 10000 by 3000 m, which is not plausible")) << with(1000);
  EXPECT_EQ(with(100), "");
  EXPECT_EQ(with(0.1), "");
  EXPECT_TRUE(contains(with(0.0002), "which is not plausible")) << with(0.0002);
}

// The outline was drawn twice, the second time in other pieces.
TEST(LookAhead, blocks_of_an_outline_drawn_twice_are_not_outside) {
  const auto report = check_of(case_text(R"("drawing": {"edge_node_ratio": 0.001, "boundary_count": 9, "joints": [
    [0, 0, 4, 0, 1], [4, 0, 4, 4, 1], [4, 4, 0, 4, 1], [0, 4, 0, 0, 1],
    [4, 0, 1, 0, 1], [1, 0, 0, 0, 1], [4, 4, 4, 0, 1], [0, 4, 4, 4, 1], [0, 0, 0, 4, 1], [2, 0, 2, 4, 1]],
    "fixed_lines": [[-0.1, 0.1, 4.1, 0.1]]})"));
  EXPECT_EQ(said(report, "block_outside_outline"), "");
}

// Lines that continue beyond the outline of a drawing make a block there if they close one.
TEST(LookAhead, blocks_outside_the_outline_are_counted) {
  const auto report = check_of(case_text(R"("drawing": {"edge_node_ratio": 0.001, "boundary_count": 4, "joints": [
    [0, 0, 4, 0, 1], [4, 0, 4, 4, 1], [4, 4, 0, 4, 1], [0, 4, 0, 0, 1],
    [2, 0, 2, 4, 1], [4, 1, 6, 1, 1], [6, 1, 6, 2, 1], [6, 2, 4, 2, 1]],
    "fixed_lines": [[0.1, 0.1, 3.9, 0.1]]})"));
  EXPECT_TRUE(contains(said(report, "block_outside_outline"), "1 block lies of 3 outside the boundary lines"))
      << report["warnings"];
}

// The classic: millimetres with the gravity of metres, and a modulus in pascals.
TEST(LookAhead, units_that_contradict_are_told) {
  const std::string units = R"("units": {"length": "mm", "mass": "kg", "time": "s"},)";
  const auto report = check_of(case_text(blocks({kFloor, rectangle(4, 1, 6, 3)}), units));
  const std::string sentence = said(report, "implausible_gravity");
  EXPECT_TRUE(contains(sentence, "gravity 9.81 is 0.00981 m/s2 in the declared units (mm, kg, s)")) << sentence;
  EXPECT_EQ(said(check_of(case_text(blocks({kFloor, rectangle(4, 1, 6, 3)}))), "implausible_gravity"), "");
}

// Each plausible by itself.
TEST(LookAhead, gravity_of_another_unit_is_told) {
  const auto told = [](const char* length, const char* mass, const char* gravity) {
    const std::string units = fmt::format(R"("units": {{"length": "{}", "mass": "{}", "time": "s"}},)", length, mass);
    const std::string text =
        case_text(blocks({kFloor, rectangle(4, 1, 6, 3)}), units, fmt::format(R"("gravity": {},)", gravity));
    return said(check_of(text, {"--trial", "0"}), "implausible_gravity");
  };
  EXPECT_TRUE(contains(told("ft", "slug", "9.81"), "gravity 9.81 is that of the earth in m/s2, but 2.99 m/s2"));
  EXPECT_TRUE(contains(told("m", "kg", "32.2"), "that of the earth in ft/s2"));
  EXPECT_FALSE(contains(told("ft", "slug", "32.174"), "that of the earth"));
  EXPECT_FALSE(contains(told("m", "kg", "1.62"), "that of the earth")) << "the moon's";
  EXPECT_FALSE(contains(told("m", "kg", "981"), "that of the earth")) << "100 g";
  EXPECT_FALSE(contains(told("m", "kg", "0"), "that of the earth"));
}

TEST(LookAhead, gravity_upward_and_friction_in_radians_are_told) {
  const std::string geometry = blocks({kFloor, rectangle(4, 1, 6, 3)});
  std::string text = case_text(geometry, kUnits, R"("gravity": -9.81,)");
  EXPECT_TRUE(contains(said(check_of(text, {"--trial", "0"}), "gravity_points_upward"), "gravity points upward, 9.81"));
  text = case_text(geometry);
  text.replace(text.find("\"friction_angle_deg\": 30"), 24, "\"friction_angle_deg\": 0.5236");
  EXPECT_TRUE(contains(said(check_of(text, {"--trial", "0"}), "angle_in_radians"), "would be 30 degrees"));
}

TEST(LookAhead, strength_above_the_modulus_and_its_friction_in_radians_are_told) {
  const auto with = [](const std::string& strength) {
    std::string text = case_text(blocks({kFloor, rectangle(4, 1, 6, 3)}));
    const std::string modulus = R"("youngs_modulus": 2e10)";
    return text.insert(text.find(modulus), R"("strength": )" + strength + ", ");
  };
  EXPECT_EQ(said(check_of(with(R"({"cohesion": 1e7, "friction_deg": 30})"), {"--trial", "0"}), "implausible_strength"),
            "");
  // 2 c tan 60°.
  EXPECT_TRUE(contains(
      said(check_of(with(R"({"cohesion": 1e10, "friction_deg": 30})"), {"--trial", "0"}), "implausible_strength"),
      "a strength of 3.464e+10 under uniaxial compression is above youngs_modulus 2e+10"));
  EXPECT_TRUE(contains(
      said(check_of(with(R"({"cohesion": 1e7, "friction_deg": 0.5236})"), {"--trial", "0"}), "angle_in_radians"),
      "would be 30 degrees"));
  // Dilation alone of less than a degree, and beside friction in degrees.
  const auto dilating = [&](const char* angle) {
    const std::string strength = R"({"cohesion": 1e7, "friction_deg": 35, "dilation_deg": )" + std::string(angle) + "}";
    return said(check_of(with(strength), {"--trial", "0"}), "angle_in_radians");
  };
  EXPECT_TRUE(contains(dilating("0.6109"), "dilation_deg 0.6109 with friction_deg 35 would be 35 degrees"));
  EXPECT_EQ(dilating("1"), "");
  EXPECT_EQ(dilating("0"), "");
  // 2 c tan 45° in megapascals, beside a modulus in pascals.
  EXPECT_TRUE(contains(said(check_of(with(R"({"cohesion": 5})"), {"--trial", "0"}), "implausible_strength"),
                       "a strength of 10 under uniaxial compression is 5e-10 of youngs_modulus 2e+10"));
}

TEST(LookAhead, a_run_says_it_too_before_its_first_step) {
  const std::string folder = support::fresh_folder("run_looks_ahead");
  support::write_text(folder + "/case.json", case_text(blocks({kFloor, rectangle(4, 2, 6, 4)})));
  const support::ProgramRun run =
      support::run_keyblock({"run", folder + "/case.json", "-o", folder + "/out", "--set", "steps=2"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_TRUE(contains(run.messages, "1 note on the case: free_blocks")) << run.messages;
  EXPECT_TRUE(contains(support::read_text(folder + "/out/run.json"), "1 block without contact moves"));
}

// Intended motion in dynamics is a fault in statics.
TEST(LookAhead, a_block_that_touches_nothing_is_unheld_in_statics_alone) {
  const std::string text = case_text(blocks({kFloor, rectangle(4, 2, 6, 4)}));
  const auto moving = check_of(text, {"--trial", "0"});
  EXPECT_EQ(said(moving, "unheld_blocks"), "");
  EXPECT_TRUE(contains(said(moving, "free_blocks"), "first block 2 at 5, 3")) << moving;
  std::string still = text;
  still.replace(still.find(kMoves), kMoves.size(), R"("velocity_carry_over": 0)");
  const auto standing = check_of(still, {"--trial", "0"});
  EXPECT_EQ(said(standing, "free_blocks"), "");
  EXPECT_TRUE(contains(said(standing, "unheld_blocks"), "first block 2 at 5, 3")) << standing;
}

TEST(LookAhead, a_run_that_fails_at_once_is_told) {
  std::string text = case_text(blocks({kFloor, rectangle(20, 2, 22, 4)}));
  text.replace(text.find(kMoves), kMoves.size(), R"("velocity_carry_over": 0)");
  const auto report = check_of(text, {}, 1);
  EXPECT_TRUE(contains(said(report, "first_steps_fail"), "no equilibrium: block 2 accelerates")) << report;
}

// The exit code and the last line report it too; without steps there is nothing to report.
TEST(LookAhead, a_run_that_fails_at_once_is_the_last_line_of_check) {
  std::string text = case_text(blocks({kFloor, rectangle(20, 2, 22, 4)}));
  text.replace(text.find(kMoves), kMoves.size(), R"("velocity_carry_over": 0)");
  const std::string file = support::fresh_folder("check_fails") + "/case.json";
  support::write_text(file, text);
  const support::ProgramRun run = support::run_keyblock({"check", file});
  EXPECT_EQ(run.exit_code, 1) << run.messages;
  const std::string last = "keyblock: error: a run of this case fails, as its trial does: step 1 (time 0)";
  EXPECT_EQ(run.messages.find('\n', run.messages.find(last)), run.messages.size() - 1) << run.messages;
  EXPECT_EQ(support::run_keyblock({"check", file, "--trial", "0"}).exit_code, 0);
}

TEST(LookAhead, what_check_advises_to_set_it_takes_itself) {
  std::string text = case_text(blocks({kFloor, rectangle(20, 2, 22, 4)}));
  text.replace(text.find(kMoves), kMoves.size(), R"("velocity_carry_over": 0)");
  const std::string file = support::fresh_folder("check_set") + "/case.json";
  support::write_text(file, text);
  EXPECT_EQ(support::run_keyblock({"check", file, "--set", "motion=dynamic"}).exit_code, 0) << "it has no support";
  const support::ProgramRun wrong = support::run_keyblock({"check", file, "--set", "motoin=dynamic"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.messages.find("did you mean"), std::string::npos) << wrong.messages;
}

}  // namespace keyblock::look_ahead_test
