// Every legacy case holds: the old program's rules give the expected values within the stated tolerances.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "study/compare.hpp"

namespace keyblock::study {

TEST(Cases, profile_legacy_meets_every_expected_value) {
  int values = 0;
  for (const CaseFolder& folder : find_cases({KEYBLOCK_SOURCE_DIR "/legacy_cases"})) {
    if (!folder.has_expected) continue;
    const ComparedCase compared = compare_case(folder, "legacy");
    EXPECT_EQ(compared.outcome.end, RunEnd::finished) << compared.name << ": " << compared.outcome.reason;
    for (const ComparedValue& v : compared.values) {
      ++values;
      EXPECT_TRUE(v.holds()) << fmt::format("{}: {} of block {} at {}: {} for {} ± {}", compared.name, v.quantity,
                                            v.block.value_or(0), v.time, v.computed.value_or(NAN), v.expected,
                                            v.tolerance);
    }
  }
  EXPECT_GT(values, 100);
}

}  // namespace keyblock::study
