// One word for each job: jobs that ran differ from jobs that were only read, and disagreement from agreement.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/batch/batch_verdict.hpp"

#include <gtest/gtest.h>

namespace keyblock::study::batch_verdict_test {
namespace {

report::CatalogueAnswer answer(const std::string& profile, double greatest, double dx) {
  report::CatalogueMeasures measures;
  measures.displacement = greatest;
  measures.displaced_element = 3;
  return {profile, "finished", 10, 0.5, "measured point 2", dx, 0, measures};
}

report::CatalogueRow ran(double one, double other, double dx_one, double dx_other) {
  report::CatalogueRow row;
  row.outcome = "ok";
  row.answers = {answer("legacy", one, dx_one), answer("standard", other, dx_other)};
  return row;
}

}  // namespace

// Displacements of the samples cv07 and cv06, which must not be called "ok".
TEST(BatchVerdict, answers_apart_by_a_factor_differ_and_it_is_said_by_how_much_and_where) {
  const auto verdict = verdict_of(ran(0.75, 18.8, 0, 0), BatchAim::run);
  EXPECT_EQ(verdict.word, "differs");
  EXPECT_EQ(verdict.why,
            "greatest displacement 0.75 in legacy (element 3) and 18.8 in standard (element 3): 96 % apart");
  EXPECT_EQ(verdict_of(ran(0.75, 1.08, 1e-6, 1e-6), BatchAim::run).word, "differs");
}

TEST(BatchVerdict, a_point_that_ends_elsewhere_differs_though_the_greatest_agree) {
  const auto verdict = verdict_of(ran(2, 1.9, 0.5, -0.5), BatchAim::run);
  EXPECT_EQ(verdict.word, "differs");
  EXPECT_EQ(verdict.why, "measured point 2 ends 1 apart in legacy and standard: 50 % of the greatest displacement");
}

TEST(BatchVerdict, answers_that_agree_ran_and_warnings_are_said) {
  report::CatalogueRow row = ran(2, 1.9, 0.5, 0.5);
  EXPECT_EQ(verdict_of(row, BatchAim::run).word, "ran");
  row.outcome = "warnings";
  row.message = "a.ana:1: warning";
  EXPECT_EQ(verdict_of(row, BatchAim::run).word, "ran");
  EXPECT_EQ(verdict_of(row, BatchAim::run).why, "a.ana:1: warning");
  EXPECT_EQ(verdict_of(ran(0, 0, 0, 0), BatchAim::run).word, "ran") << "nothing moved";
}

TEST(BatchVerdict, a_case_that_one_profile_cannot_run_ran_by_the_other) {
  report::CatalogueRow row = ran(1, 1, 0, 0);
  row.outcome = "warnings";
  row.answers[0] = {"legacy", "expected profile standard", 0, 0, "", 0, 0, std::nullopt};
  EXPECT_EQ(verdict_of(row, BatchAim::run).word, "ran");
  EXPECT_EQ(verdict_of(row, BatchAim::run).why, "not run by legacy: expected profile standard");
}

TEST(BatchVerdict, what_never_ran_is_not_said_to_have_run) {
  report::CatalogueRow row;
  row.outcome = "ok";
  EXPECT_EQ(verdict_of(row, BatchAim::run).word, "read");
  EXPECT_FALSE(verdict_of(row, BatchAim::run).why.empty());
  EXPECT_EQ(verdict_of(row, BatchAim::check).word, "read");
  EXPECT_EQ(verdict_of(row, BatchAim::convert).word, "converted");
  row.outcome = "listed";
  EXPECT_EQ(verdict_of(row, BatchAim::run).word, "listed");
  row = ran(1, 5, 0, 0);
  row.outcome = "failed";
  row.message = "standard: exit code 4";
  EXPECT_EQ(verdict_of(row, BatchAim::run).word, "failed");
  EXPECT_EQ(verdict_of(row, BatchAim::run).why, "standard: exit code 4");
}

// Statics of a mechanism has no equilibrium, which is an answer and no failure of a program.
TEST(BatchVerdict, a_mechanism_under_statics_has_no_equilibrium_and_did_not_fail) {
  report::CatalogueRow row = ran(2, 1.9, 0, 0);
  row.outcome = "failed";
  row.message = "standard: exit code 4: keyblock: error: step 1";
  report::CatalogueAnswer& standard = row.answers.back();
  standard.end = "failed: step 1 (time 0): no equilibrium: block 2 accelerates (at 4, 3; area 2)";
  standard.reason = "step 1 (time 0): no equilibrium: block 2 accelerates (at 4, 3; area 2)";
  standard.failure = "no_equilibrium";
  const auto verdict = verdict_of(row, BatchAim::run);
  EXPECT_EQ(verdict.word, "no equilibrium");
  EXPECT_EQ(verdict.why,
            "legacy: came to its end, 10 steps; standard: step 1 (time 0): no equilibrium: block 2 accelerates "
            "(at 4, 3; area 2)");
  row.answers.front().end = "stopped at the limit of 1 s of processor time";
  EXPECT_EQ(verdict_of(row, BatchAim::run).word, "failed") << "the other profile failed for something else";
  row.answers.front().end = "finished";
  standard.failure = "undecided";
  EXPECT_EQ(verdict_of(row, BatchAim::run).word, "failed");
}

}  // namespace keyblock::study::batch_verdict_test
