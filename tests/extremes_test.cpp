// The extreme cases in brief: each figure agrees, except for a list of figures with the reason of their miss.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "tests/extremes/extreme.hpp"

namespace keyblock::extremes::extremes_test {
namespace {

struct KnownMiss {
  std::string_view quantity;  ///< its beginning
  std::string_view reason;
};

// Figures that miss. Remove the entry of a corrected figure.
constexpr std::array<KnownMiss, 6> kKnownMisses{{
    {"2.6e+09 on 2600 kg/m2: force", "25 GPa on a block of 5 GPa: strains are no longer small, and it is pressed flat"},
    {"2.6e+09 on 2600 kg/m2: most passes", "the same"},
    {"p/E 0.001: settlement", "the start shifts blocks by 0.1 m, a tenth of their size, and is settled to 2.9 %"},
    {"triangle 1e-08 high", "refused by name as without area: it is flatter than its corners are told apart"},
    {"joints 1e-05 apart: sinking", "6e-9 m: gaps between blocks of a mass ratio of 5e4 are left at their tolerance"},
    {"joints 1e-06 apart: sinking", "1.1e-7 m, the same at 5e5"},
}};

bool is_known_miss(const Extreme& row) {
  return std::ranges::any_of(kKnownMisses,
                             [&](const KnownMiss& miss) { return row.quantity.starts_with(miss.quantity); });
}

}  // namespace

class ExtremeCases : public ::testing::TestWithParam<ExtremeCase> {};

TEST_P(ExtremeCases, every_figure_holds) {
  for (const Extreme& row : GetParam().rows(Effort::brief))
    EXPECT_TRUE(row.holds() || is_known_miss(row)) << table_head() << table_row(row);
}

INSTANTIATE_TEST_SUITE_P(Brief, ExtremeCases, ::testing::ValuesIn(extreme_cases()),
                         [](const auto& given) { return "ext_" + std::string(given.param.id).substr(4); });

}  // namespace keyblock::extremes::extremes_test
