// A slope of the measurements of speed, whose 60th step has rounded corners that overlap: its estimates alternated.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::alternating_estimates_test {

// The gap of two rounded corners opened twice as far as their rows at mid-step say. Each iteration then went from one
// side of the balance to the other, at any step size, and the run ended with exit code 4.
TEST(SmoothSolve, gaps_steeper_than_their_rows_do_not_alternate_without_end) {
  const std::string scene = KEYBLOCK_SOURCE_DIR "/tests/run/scenes/slope_of_350_blocks";
  const support::ProgramRun run =
      support::run_keyblock({"run", scene + ".geo", scene + ".ana", "--profile", "standard", "--set", "steps=62", "-o",
                             support::fresh_folder("alternating") + "/out", "--no-pictures", "--contacts", "none"});
  EXPECT_LE(run.exit_code, 1) << run.messages;
}

}  // namespace keyblock::alternating_estimates_test
