// The result of a run of a batch: the last point of its history, or the reason why there is none.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/batch/batch_answers.hpp"

#include <gtest/gtest.h>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::study::batch_answers_test {
namespace {

using report::CatalogueAnswer;
using support::write_text;

std::filesystem::path run_folder(const std::string& name, const std::string& record, const std::string& history) {
  const std::filesystem::path folder = support::fresh_folder("answers_" + name);
  write_text(folder / "run.json", record);
  write_text(folder / "history.csv", history);
  return folder;
}

const std::string kHistory =
    "step,time [T],x1 [L],y1 [L],dx1 [L],dy1 [L],x2 [L],y2 [L],dx2 [L],dy2 "
    "[L]\n0,0,1,1,0,0,2,2,0,0\n4,0.5,1,1,7,8,2,2,3,-4\n";

std::string record(int measured_points) {
  return R"({"outcome": {"end": "finished", "steps": 4, "time": 0.5}, "counts": {"measured_points": )" +
         std::to_string(measured_points) + "}}";
}

}  // namespace

TEST(BatchAnswers, the_last_point_of_the_last_row_is_the_answer) {
  const CatalogueAnswer answer = answer_in(run_folder("measured", record(2), kHistory), "legacy");
  EXPECT_EQ(answer.profile, "legacy");
  EXPECT_EQ(answer.end, "finished");
  EXPECT_EQ(answer.steps, 4);
  EXPECT_EQ(answer.time, 0.5);
  EXPECT_EQ(answer.of_what, "measured point 2");
  EXPECT_EQ(answer.dx, 3);
  EXPECT_EQ(answer.dy, -4);
  EXPECT_EQ(answer_in(run_folder("centroids", record(0), kHistory), "legacy").of_what, "centroid of block 2");
}

// Then the table follows those that move most, under their own numbers.
TEST(BatchAnswers, of_many_blocks_the_one_that_moves_most_is_the_answer) {
  const std::string history =
      "step,time [T],x4 [L],y4 [L],dx4 [L],dy4 [L],x7 [L],y7 [L],dx7 [L],dy7 [L]\n4,0.5,1,1,7,8,2,2,3,-4\n";
  const auto answer = [&](int most) {
    return answer_in(run_folder("many",
                                R"({"outcome": {"end": "finished", "steps": 4, "time": 0.5},
               "counts": {"measured_points": 0, "blocks": 12, "most_contacts": 3},
               "extremes": {"greatest_displacement": {"value": 7, "element": )" +
                                    std::to_string(most) + R"(},
                            "least_principal_stress": {"value": -2, "element": 1},
                            "greatest_principal_stress": {"value": 0.5, "element": 2}}})",
                                history),
                     "legacy");
  };
  EXPECT_EQ(answer(4).of_what, "centroid of block 4");
  EXPECT_EQ(answer(4).dy, 8);
  EXPECT_EQ(answer(9).of_what, "centroid of block 7");  // not followed: the last one
}

TEST(BatchAnswers, measures_of_all_elements_come_from_the_record) {
  const auto record = [](const std::string& more) {
    return R"({"outcome": {"end": "finished", "steps": 4, "time": 0.5},
               "counts": {"measured_points": 2, "most_contacts": 12},
               "extremes": {"greatest_displacement": {"value": 7, "element": 1},
                "least_principal_stress": {"value": -2, "element": 1},
                            "greatest_principal_stress": {"value": 0.5, "element": 2}})" +
           more + "}";
  };
  const auto measures = answer_in(run_folder("dynamic", record(""), kHistory), "legacy").measures;
  ASSERT_TRUE(measures);
  EXPECT_EQ(measures->displacement, 7);
  EXPECT_EQ(measures->least_stress, -2);
  EXPECT_EQ(measures->greatest_stress, 0.5);
  EXPECT_EQ(measures->contacts, 12);
  EXPECT_FALSE(measures->is_static);
  const auto way = [&](const std::string& share) {
    return answer_in(run_folder("static", record(R"(, "equilibrium": {"share": )" + share + "}"), kHistory), "legacy")
        .measures.value();
  };
  EXPECT_TRUE(way("null").is_static);
  EXPECT_EQ(way("null").equilibrium_share, std::nullopt);
  EXPECT_EQ(way("0.25").equilibrium_share, 0.25);
}

TEST(BatchAnswers, a_missing_or_damaged_record_is_an_end_too) {
  EXPECT_EQ(answer_in("/no/such", "legacy").end, "no result");
  EXPECT_TRUE(
      answer_in(run_folder("torn", "{\"outcome\"", kHistory), "legacy").end.starts_with("run.json cannot be read"));
  const std::string failed =
      R"({"outcome": {"end": "failed", "reason": "too far", "steps": 4, "time": 0.5},
          "counts": {"measured_points": 2}})";
  EXPECT_EQ(answer_in(run_folder("failed", failed, kHistory), "legacy").end, "failed: too far");
}

TEST(BatchAnswers, verdicts_of_a_comparison_are_one_sentence) {
  EXPECT_EQ(
      verdict_of(R"({"cases": [{"runs": [{"profile": "legacy", "holds": true}, {"profile": "standard", "holds": false},
                           {"profile": "draft", "not_run": "no"},
                            {"profile": "legacy", "variant": "b", "holds": false}]}]})"),
      "legacy: hold, standard: missed, draft: not run");
  EXPECT_EQ(verdict_of("no json"), "not compared");
}

TEST(BatchAnswers, only_whole_answers_differ) {
  const CatalogueAnswer first{"legacy", "finished", 1, 1, "measured point 1", 1, 2, std::nullopt};
  CatalogueAnswer last{"standard", "finished", 1, 1, "measured point 1", 4, 6, std::nullopt};
  EXPECT_EQ(difference_of({first, last}), 5);
  EXPECT_EQ(difference_of({first}), std::nullopt);
  last.end = "failed";
  EXPECT_EQ(difference_of({first, last}), std::nullopt);
}

}  // namespace keyblock::study::batch_answers_test
