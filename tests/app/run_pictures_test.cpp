// Pictures of a run whose scene changes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::run_pictures_test {

// Two blocks side by side under a ceiling, between them a joint of material b. Their lower halves are excavated along
// edges of material c. The remaining blocks have as many corners as before, but begin at others.
TEST(RunPictures, joints_are_those_of_the_scene_at_the_end) {
  const std::string folder = support::fresh_folder("run_pictures");
  support::write_text(folder + "/case.json", R"({"keyblock": 2,
 "drawing": {"edge_node_ratio": 0.001, "boundary_count": 4,
  "joints": [[0, 0, 10, 0, "a"], [10, 0, 10, 10, "a"], [10, 10, 0, 10, "a"], [0, 10, 0, 0, "a"], [5, 0, 5, 10, "b"]],
  "fixed_lines": [[0.1, 9.9, 9.9, 9.9]]},
 "analysis": {"step_count": 1, "time_step": 0.001, "gravity": 9.81,
  "block_materials": [{"density": 2500, "youngs_modulus": 5e9}],
  "joint_materials": [{"name": "a"}, {"name": "b"}, {"name": "c"}]},
 "stages": [{"name": "one", "steps": 2}, {"name": "two", "steps": 2, "excavations":
  [{"outline": [[-1, -1], [11, -1], [11, 4], [-1, 4]], "joint_material": "c"}]}]})");
  const support::ProgramRun run =
      support::run_keyblock({"run", folder + "/case.json", "-o", folder + "/out", "--contacts", "none"});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  const std::string svg = support::read_text(folder + "/out/picture.svg");
  EXPECT_NE(svg.find(">c (joint material 3)<"), std::string::npos);
  // Colours of materials 2 and 3: upright lines of the joint, level ones of the new edges.
  const auto directions = [&](const std::string& colour) {
    const std::regex line("<polyline[^>]*points=\"([0-9.]+),([0-9.]+) ([0-9.]+),([0-9.]+)\"[^>]*stroke=\"" + colour);
    std::string found;
    for (std::sregex_iterator i(svg.begin(), svg.end(), line), end; i != end; ++i) {
      const double across = std::abs(std::stod((*i)[1]) - std::stod((*i)[3]));
      const double down = std::abs(std::stod((*i)[2]) - std::stod((*i)[4]));
      if (across + down > 50) found += across > down ? '-' : '|';
    }
    return found;
  };
  EXPECT_EQ(directions("#d55e00"), "||") << "one side of each block";
  EXPECT_EQ(directions("#0072b2"), "--");
}

}  // namespace keyblock::run_pictures_test
