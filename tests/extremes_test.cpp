// The extreme cases in brief: each figure holds, but for those listed with the reason why not.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/extremes/extreme.hpp"

namespace keyblock::extremes {

class ExtremeCases : public ::testing::TestWithParam<ExtremeCase> {};

TEST_P(ExtremeCases, every_figure_holds) {
  for (const Extreme& row : GetParam().rows(Effort::brief)) EXPECT_TRUE(row.holds()) << table_head() << table_row(row);
}

INSTANTIATE_TEST_SUITE_P(Brief, ExtremeCases, ::testing::ValuesIn(extreme_cases()),
                         [](const auto& given) { return "ext_" + std::string(given.param.id).substr(4); });

}  // namespace keyblock::extremes
