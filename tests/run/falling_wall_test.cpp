// A wall whose courses fall on one another: nearly a thousand contacts close within a few steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "formats/case.hpp"
#include "run/prepare.hpp"
#include "run/run.hpp"

namespace keyblock::falling_wall_test {

// Contact forces must not cycle, as they once did at step 97 of 105. No step may leave a residual beyond the limit of a
// reliable run. The impacts that push bricks apart lift them: 0.14 J of the energy that 0.2 s release.
class FallingWall : public testing::TestWithParam<const char*> {};

TEST_P(FallingWall, of_513_bricks_lands) {
  const Problem problem = formats::load_case({KEYBLOCK_SOURCE_DIR "/tests/run/scenes/wall_of_513_bricks.json"}).problem;
  const Prepared prepared = prepare(problem, "standard", {{"enforcement", GetParam()}});
  double worst = 0, least = std::numeric_limits<double>::infinity(), rise = 0, first = 0, last = 0;
  int unsettled = 0, steps = 0;
  Observer observer;
  observer.on_step = [&](const StepReport& step) {
    worst = std::max(worst, step.residual);
    unsettled += step.unsettled_contacts;
    ++steps;
  };
  observer.on_ledger = [&](const LedgerRow& row) {
    const double energy = row.stored.total();
    if (std::isinf(least)) first = row.stored.gravity;
    last = row.stored.gravity;
    rise = std::max(rise, energy - least);
    least = std::min(least, energy);
  };
  EXPECT_EQ(run(prepared.scene, 1000, observer).end, RunEnd::finished);
  EXPECT_EQ(steps, 105);
  EXPECT_LE(worst, 1e-4);
  EXPECT_EQ(unsettled, 0);
  EXPECT_GT(first - last, 0);
  EXPECT_LT(rise, 1e-5 * (first - last));
}

// By penalty in `make validate`: twice the linear solves.
INSTANTIATE_TEST_SUITE_P(Enforcements, FallingWall, testing::Values("automatic", "penalty"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace keyblock::falling_wall_test
