// A slope of the measurements of speed, whose 60th step has rounded corners that overlap: its estimates alternated.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/program.hpp"
#include "tests/support/shared_folder.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::alternating_estimates_test {

// The gap of two rounded corners opened twice as far as their rows at mid-step say. Each iteration then went from one
// side of the balance to the other, at any step size, and the run ended with exit code 4.
TEST(SmoothSolve, gaps_steeper_than_their_rows_do_not_alternate_without_end) {
  const std::filesystem::path inputs = shared_folder() / "findings" / "inputs" / "speed";
  if (!std::filesystem::exists(inputs / "j350.geo")) GTEST_SKIP() << "the slope of 350 blocks lies only in ../shared";
  const support::ProgramRun run = support::run_keyblock(
      {"run", (inputs / "j350.geo").string(), (inputs / "j350_slid.ana").string(), "--profile", "standard", "--set",
       "steps=62", "-o", support::fresh_folder("alternating") + "/out", "--no-pictures", "--contacts", "none"});
  EXPECT_LE(run.exit_code, 1) << run.messages;
}

}  // namespace keyblock::alternating_estimates_test
