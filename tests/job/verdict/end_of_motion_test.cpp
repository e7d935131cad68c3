// End of a run in the summary and in run.json: rest, motion, equilibrium, largest displacement.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::end_of_motion_test {
namespace {

/// A fixed floor and a square of 1 m at `gap` above it, in metres and seconds.
std::string block_over_floor(const std::string& gap, const std::string& steps, const std::string& more = "") {
  return R"({"keyblock": 2, "units": {"length": "m", "mass": "kg", "time": "s"}, "blocks": {"blocks": [
    {"outer": [[-2, -1, 1], [3, -1, 1], [3, 0, 1], [-2, 0, 1]]},
    {"outer": [[0, )" +
         gap + ", 1], [1, " + gap + ", 1], [1, 1+" + gap + ", 1], [0, 1+" + gap + R"(, 1]]}],
    "fixed_points": [[-1.9, -0.9, 1], [2.9, -0.1, 1]], "measured_points": [[0.5, 0.5, 2]]},
    "analysis": {"step_count": )" +
         steps + R"(, "time_step": 0.001, "block_materials": [{"density": 2500, "youngs_modulus": 5e9,
    "poissons_ratio": 0.2}], "joint_materials": [{"friction_angle_deg": 30}]})" +
         more + "}";
}

struct Ended {
  support::ProgramRun run;
  nlohmann::json record, motion;

  bool says(const std::string& words) const { return support::contains(run.messages, words); }
};

Ended ended(std::string text, const std::vector<std::string>& more = {}) {
  // Sums of coordinates, as 1+0.5.
  for (std::size_t at; (at = text.find("1+")) != std::string::npos;) {
    const std::size_t end = text.find(',', at);
    text.replace(at, end - at, std::to_string(1 + std::stod(text.substr(at + 2, end - at - 2))));
  }
  const std::string folder = support::fresh_folder("end_of_motion");
  support::write_text(folder + "/in.json", text);
  std::vector<std::string> arguments{"run", folder + "/in.json", "-o", folder + "/out"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  Ended made{support::run_keyblock(arguments), {}, {}};
  made.record = nlohmann::json::parse(support::read_text(folder + "/out/run.json"));
  made.motion = made.record["outcome"].value("motion", nlohmann::json());
  return made;
}

}  // namespace

TEST(EndOfMotion, a_block_on_a_floor_came_to_rest) {
  const Ended end = ended(block_over_floor("0", "50"));
  EXPECT_TRUE(end.says("  motion    came to rest (kinetic energy ")) << end.run.messages;
  EXPECT_EQ(end.motion["state"], "at_rest");
  EXPECT_LE(end.motion["kinetic_share"], 1e-6);
}

// 0.1 s of free fall: v = g t = 0.981 m/s, 49 mm.
TEST(EndOfMotion, a_block_that_falls_still_moves_at_the_speed_of_its_fall) {
  for (const char* profile : {"standard", "legacy"}) {
    const Ended end = ended(block_over_floor("0.5", "100"), {"--profile", profile});
    EXPECT_TRUE(end.says("still moving: block 2 near (0.5, 0.9")) << end.run.messages;
    EXPECT_TRUE(end.says("at 0.98") && end.says(" m/s")) << end.run.messages;
    EXPECT_TRUE(end.says("  largest   block 2 near (") && end.says("; measured point 1: 4")) << end.run.messages;
    EXPECT_TRUE(end.motion["sentences"][1].get<std::string>().starts_with("largest displacement: block 2 near ("))
        << end.run.messages;
    EXPECT_EQ(end.motion["state"], "moving");
    EXPECT_EQ(end.motion["fastest"]["block"], 2);
    EXPECT_NEAR(end.motion["fastest"]["speed"], 0.981, 0.01);
    EXPECT_NEAR(end.motion["farthest"]["displacement"], 0.04905, 0.0005);
    EXPECT_EQ(end.record["unit_of"]["outcome.motion.fastest.speed"], "m/s");
    EXPECT_EQ(end.record["unit_of"]["outcome.motion.farthest.displacement"], "m");
  }
}

// The energy of a pebble is small beside that of the other block, which is stable; the message reports it all the same.
TEST(EndOfMotion, a_pebble_that_flies_beside_a_large_block_still_moves) {
  std::string text = block_over_floor("0", "50");
  const std::string end_of_blocks = R"(],
    "fixed_points")";
  text.insert(text.find(end_of_blocks),
              R"(, {"outer": [[1.5, 1, 1], [1.501, 1, 1], [1.501, 1.001, 1], [1.5, 1.001, 1]]})");
  const Ended end = ended(text);
  EXPECT_TRUE(end.says("still moving: block 3 near (1.5")) << end.run.messages;
}

TEST(EndOfMotion, statics_ends_in_equilibrium_or_without_one) {
  const Ended stands = ended(block_over_floor("0", "1", R"(, "run": {"set": {"motion": "static"}})"));
  EXPECT_TRUE(stands.says("in equilibrium")) << stands.run.messages;
  EXPECT_EQ(stands.motion["state"], "equilibrium");
  EXPECT_TRUE(stands.motion["kinetic_share"].is_null());
  const Ended old = ended(block_over_floor("0", "200"), {"--profile", "legacy", "--set", "velocity_carry_over=0"});
  EXPECT_EQ(old.motion["state"], "equilibrium") << old.run.messages;
}

TEST(EndOfMotion, elements_of_bodies_are_called_elements) {
  const Ended end = ended(block_over_floor("0.5", "20", R"(, "covers": {"mesh": {"side": 0.5}})"));
  EXPECT_TRUE(end.says("still moving: element ")) << end.run.messages;
  EXPECT_TRUE(end.motion["fastest"].contains("element")) << end.motion;
}

// The first step fails: nothing has moved, and no message is about motion.
TEST(EndOfMotion, a_run_without_a_step_says_nothing_of_motion) {
  const Ended falls = ended(block_over_floor("5", "1", R"(, "run": {"set": {"motion": "static"}})"));
  EXPECT_EQ(falls.run.exit_code, 4) << falls.run.messages;
  EXPECT_TRUE(falls.motion.is_null()) << falls.motion;
}

}  // namespace keyblock::end_of_motion_test
