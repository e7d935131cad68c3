// Single blocks that sums over the scene hide: one that is thrown, and one that hangs without tensile strength.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/verdict/block_watch.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::block_watch_test {
namespace {

/// A square of the given side on a fixed floor of 4 by 1, by default under Shi's rules.
support::ProgramRun run_of(double side, int steps, const std::string& more = "",
                           const std::vector<std::string>& options = {"--profile", "legacy"}) {
  const std::string folder = support::fresh_folder("block_watch");
  support::write_text(folder + "/in.json", fmt::format(R"({{"keyblock": 2, "blocks": {{"blocks": [
    {{"outer": [[0, -1, 1], [4, -1, 1], [4, 0, 1], [0, 0, 1]]}},
    {{"outer": [[1, 0, 1], [{0}, 0, 1], [{0}, {1}, 1], [1, {1}, 1]]}}],
    "fixed_points": [[0.5, -0.5, 1], [3.5, -0.5, 1]]}}, "analysis": {{"step_count": {2}, "time_step": 0.001,
    "block_materials": [{{"density": 2500, "youngs_modulus": 5e9, "poissons_ratio": 0.25}}],
    "joint_materials": [{{"friction_angle_deg": 30{3}}}]}}}})",
                                                       1 + side, side, steps, more));
  std::vector<std::string> arguments{"run", folder + "/in.json", "-o", folder + "/out"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return support::run_keyblock(arguments);
}

}  // namespace

// It weighs 2.5e-8 N and is thrown at 0.5 m/s, which its floor's energy hides.
TEST(BlockWatch, a_tiny_block_that_is_flung_is_doubted) {
  const support::ProgramRun run = run_of(1e-6, 20);
  EXPECT_EQ(run.exit_code, 1) << run.messages;
  EXPECT_TRUE(support::contains(run.messages, "[block_thrown]")) << run.messages;
}

TEST(BlockWatch, blocks_at_rest_are_trusted) {
  for (const double side : {1.0, 0.1})
    for (const char* profile : {"legacy", "standard"}) {
      const support::ProgramRun run = run_of(side, 100, "", {"--profile", profile});
      EXPECT_EQ(run.exit_code, 0) << side << profile << run.messages;
    }
}

TEST(BlockWatch, a_block_that_hangs_without_tensile_strength_is_doubted) {
  const std::vector<std::string> upward{"--profile", "legacy", "--set", "gravity.y=9.81"};
  const support::ProgramRun run = run_of(1, 100, "", upward);
  EXPECT_EQ(run.exit_code, 1) << run.messages;
  EXPECT_TRUE(support::contains(run.messages, "[tension_without_strength]")) << run.messages;
  EXPECT_EQ(run_of(1, 100, R"(, "tensile_strength": 1e6)", upward).exit_code, 0) << "it may hang";
}

}  // namespace keyblock::block_watch_test
