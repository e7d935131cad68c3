// Every legacy case agrees with its values in both profiles, and in every variant, within the stated tolerances.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <ostream>

#include "settings/profile.hpp"
#include "study/cases/compare.hpp"

namespace keyblock::study {

/// Name of a case in the output of GoogleTest, which looks in the namespace of the type.
void PrintTo(const CaseFolder& folder, std::ostream* out) {
  *out << folder.name;
}

}  // namespace keyblock::study

namespace keyblock::study::cases_test {
namespace {

/// The cases with expected values that are not slow.
std::vector<CaseFolder> quick_cases() {
  std::vector<CaseFolder> cases = find_cases({KEYBLOCK_SOURCE_DIR "/legacy_cases"});
  std::erase_if(cases, [](const CaseFolder& c) { return !c.has_expected || read_case_file(c).is_slow; });
  return cases;
}

std::string test_name(const ::testing::TestParamInfo<CaseFolder>& info) {
  std::string name = info.param.name;
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

void expect_holds(const ComparedCase& run) {
  EXPECT_TRUE(run.holds()) << run.profile << ' ' << run.variant << ": " << run.not_run << run.outcome.reason;
  for (const ComparedValue& v : run.values)
    EXPECT_FALSE(v.is_missed()) << fmt::format("{} {}: {} of block {} at {}: {} for {} ± {}", run.profile, run.variant,
                                               v.quantity, v.block.value_or(0), v.time, v.computed.value_or(NAN),
                                               v.expected, v.tolerance);
}

}  // namespace

class Cases : public ::testing::TestWithParam<CaseFolder> {};

TEST_P(Cases, meet_every_expected_value) {
  const CaseComparison comparison = compare_in(GetParam(), rule_names());
  for (const ComparedCase& run : comparison.plain) expect_holds(run);
  for (const ComparedCase& run : comparison.variants) expect_holds(run);
}

INSTANTIATE_TEST_SUITE_P(Legacy, Cases, ::testing::ValuesIn(quick_cases()), test_name);

TEST(CasesAtLarge, every_expected_value_is_judged_in_a_profile_that_runs) {
  int judged = 0;
  for (const CaseFolder& folder : quick_cases()) {
    const CaseFile file = read_case_file(folder);
    for (const ExpectedValue& value : read_expected(folder.folder / "expected.csv")) {
      const bool is_judged = std::ranges::any_of(rule_names(), [&](const std::string& profile) {
        return value.is_judged_in(profile) && !file.not_run.contains(profile);
      });
      EXPECT_TRUE(is_judged) << folder.name << ": " << value.quantity;
      ++judged;
    }
  }
  EXPECT_GT(judged, 100);
}

}  // namespace keyblock::study::cases_test
