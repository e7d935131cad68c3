// Runs warn if closing contacts of NMM bodies take much of the energy.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::closing_messages_test {
namespace {

/// A block of half a metre that strikes the middle of a beam of eight metres on covers at 4.4 m/s.
std::string struck_beam(const std::string& density, const std::string& modulus) {
  return R"({"keyblock": 2, "blocks": {"blocks": [
    {"material": 1, "outer": [[0, 0, 1], [8, 0, 1], [8, 0.5, 1], [0, 0.5, 1]]},
    {"material": 2, "outer": [[3.75, 0.501, 1], [4.25, 0.501, 1], [4.25, 1.001, 1], [3.75, 1.001, 1]]}]},
    "analysis": {"step_count": 10, "time_step": 2e-3, "gravity": 9.81, "plane_strain": false,
    "allowed_displacement_ratio": 1, "joint_materials": [{"friction_angle_deg": 20}], "block_materials": [
    {"density": )" +
         density + R"(, "youngs_modulus": )" + modulus + R"(, "poissons_ratio": 0.2},
    {"density": 2500, "youngs_modulus": 5e10, "poissons_ratio": 0.2, "initial_velocity": [0, -4.429, 0]}]},
    "covers": {"functions": "derived", "mesh": {"side": 0.25, "materials": [[1]]}, "displacements": [
    {"along": [[0, 0.5], [0, 0]]}, {"along": [[8, 0], [8, 0.5]]}]}})";
}

bool tells_of_closing(const std::string& name, const std::string& text) {
  const std::string folder = support::fresh_folder("closing_messages_" + name);
  support::write_text(folder + "/in.json", text);
  const support::ProgramRun run = support::run_keyblock({"run", folder + "/in.json", "-o", folder + "/out"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  return run.messages.find("[energy_lost_in_closing]") != std::string::npos;
}

}  // namespace

// On a heavy stiff beam the impact lasts a fraction of a step of 2 ms, whose closing takes the energy. A light beam
// moves with the block.
TEST(ClosingMessages, a_blow_that_the_step_does_not_resolve_is_told_of_and_one_that_it_does_is_not) {
  EXPECT_TRUE(tells_of_closing("heavy", struck_beam("2500", "5e10")));
  EXPECT_FALSE(tells_of_closing("light", struck_beam("2.5", "5e8")));
}

}  // namespace keyblock::closing_messages_test
