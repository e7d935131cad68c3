// The verdict on a run: its end counts first, then doubts, then the motion.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/verdict/run_verdict.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace keyblock::run_verdict_test {
namespace {

using Json = nlohmann::ordered_json;

RunVerdict of(const char* outcome) {
  return verdict_of({{"outcome", Json::parse(outcome)}});
}

TEST(RunVerdict, states_that_differ_have_different_words) {
  EXPECT_EQ(of(R"({"end": "finished", "motion": {"state": "moving"}})").words, "still moving");
  EXPECT_EQ(of(R"({"end": "stopped", "motion": {"state": "moving"}})").words, "stopped early");
  EXPECT_EQ(of(R"({"end": "finished", "motion": {"state": "at_rest"}})").words, "came to rest");
  EXPECT_EQ(of(R"({"end": "finished", "motion": {"state": "equilibrium"}})").words, "in equilibrium");
  EXPECT_EQ(of(R"({"end": "finished", "motion": {"state": "not_equilibrium"}})").words, "not in equilibrium");
  EXPECT_EQ(of(R"({"end": "finished"})").words, "finished");
  EXPECT_EQ(verdict_of(Json()).words, "run not finished");
}

TEST(RunVerdict, an_equilibrium_that_was_not_reached_is_not_good) {
  EXPECT_EQ(of(R"({"end": "finished", "motion": {"state": "not_equilibrium"}})").tone, "warn");
}

TEST(RunVerdict, failures_stops_and_doubts_give_their_reason) {
  const RunVerdict failed = of(R"({"end": "failed", "reason": "block 2 accelerates", "doubts": ["a doubt"]})");
  EXPECT_EQ(failed.state, RunState::failed);
  EXPECT_EQ(failed.reason, "block 2 accelerates");
  EXPECT_EQ(of(R"({"end": "stopped", "ended_early": "crest.d passed 0.05 m"})").reason, "crest.d passed 0.05 m");
  const RunVerdict doubted = of(R"({"end": "finished", "motion": {"state": "at_rest"}, "doubts": ["a doubt"]})");
  EXPECT_EQ(doubted.tone, "bad");
  EXPECT_EQ(doubted.reason, "a doubt");
}

TEST(RunVerdict, odd_records_have_a_verdict) {
  for (const char* odd : {"3", "[]", "{}", R"({"end": 3})", R"({"end": "finished", "motion": [1], "doubts": 4})"})
    EXPECT_FALSE(of(odd).words.empty()) << odd;
}

}  // namespace
}  // namespace keyblock::run_verdict_test
