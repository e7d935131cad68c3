// Sums over steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/step_record.hpp"

#include <gtest/gtest.h>

namespace keyblock::step_record_test {

TEST(StepTotals, steps_are_counted_by_their_passes_in_bins_whose_limits_belong_to_them) {
  StepTotals totals;
  for (const int passes : {0, 1, 3, 4, 10, 11, 40, 41, 500}) {
    StepReport step;
    step.passes = passes;
    step.penetration_share = passes == 11 ? 0.25 : 0.125;
    totals.add(step);
  }
  EXPECT_EQ(totals.steps_by_passes, (std::array<int, 5>{1, 2, 2, 2, 2}));
  EXPECT_EQ(totals.most_passes, 500);
  EXPECT_EQ(totals.passes, 610U);
  EXPECT_EQ(totals.penetration_share, 0.25);
}

}  // namespace keyblock::step_record_test
