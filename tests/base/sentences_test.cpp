// Sentences are made of values, by one table.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/sentences/sentences.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <stdexcept>

#include "base/words/diagnostics.hpp"

namespace keyblock::sentences_test {
namespace {

std::array<std::span<const Sentence>, 6> all_parts() {
  return {sentences_ahead(),      sentences_of_cases(), sentences_of_cuts(),
          sentences_of_readers(), sentences_of_runs(),  sentences_of_steps()};
}

}  // namespace

TEST(Sentences, forms_are_sorted_and_unique) {
  for (const std::span<const Sentence> part : all_parts()) {
    EXPECT_GT(part.size(), 30U);
    EXPECT_EQ(std::ranges::adjacent_find(part, std::greater_equal<>{}, &Sentence::form), part.end());
  }
}

TEST(Sentences, every_sentence_of_a_warning_has_a_row_of_diagnostics) {
  for (const std::span<const Sentence> part :
       {sentences_ahead(), sentences_of_cases(), sentences_of_cuts(), sentences_of_readers(), sentences_of_runs()})
    for (const Sentence& row : part)
      EXPECT_NE(find_diagnostic(Finding{std::string(row.form)}.code()), nullptr) << row.form;
}

TEST(Sentences, braces_and_brackets_are_closed) {
  for (const std::span<const Sentence> part : all_parts())
    for (const Sentence& row : part)
      for (const auto& [open, close] : {std::pair{'{', '}'}, std::pair{'[', ']'}})
        EXPECT_EQ(std::ranges::count(row.text, open), std::ranges::count(row.text, close)) << row.form;
}

TEST(Sentences, values_are_formatted_as_the_text_has_it) {
  EXPECT_EQ(sentence_of({"sunk_beyond_limit", {{{"share", 0.12345}, {"limit", 0.1}}}}),
            "blocks overlapped by 0.123 of the size of the smaller; limit 0.1 (penetration_limit)");
  EXPECT_EQ(sentence_of({"tips_still_go_on", {{{"tip", 2}}, {}, {}, {{{12470, 0.5}}}}}),
            "tip 2 at 12470, 0.5 still extends under the loads of the last step");
  EXPECT_EQ(sentence_of({"start_settled:no_forces", {{{"steps", 1}}}}),
            "1 step of the initial state found no contact forces");
}

TEST(Sentences, a_part_in_brackets_needs_its_value) {
  Facts facts{{{"stage", 2}, {"step", 40}}};
  EXPECT_EQ(sentence_of({"stage_not_balanced", facts}), "stage 2 ends after step 40 without the required equilibrium");
  facts.texts.emplace_back("name", "bench");
  EXPECT_EQ(sentence_of({"stage_not_balanced", facts}),
            "stage 2 (bench) ends after step 40 without the required equilibrium");
}

TEST(Sentences, a_frame_holds_the_sentence_of_the_cause) {
  const Finding cause{"no_equilibrium:several",
                      {{{"smallest", 7}, {"area", 0.04}, {"percent_of_mean", 0.3125}, {"least_fixed_points", 2}},
                       {{"noun", "element"}},
                       {3, 7},
                       {{{2.5, 1}}}}};
  EXPECT_EQ(framed("in_step", {{{"step", 12}, {"time", 0.1}}}, cause),
            "step 12 (time 0.1): no equilibrium: elements 3, 7 accelerate (the smallest, 7, at 2.5, 1; area 0.04, "
            "0.312 % of the mean); its body has fewer than two fixed points");
}

TEST(Sentences, an_unknown_form_and_a_missing_value_are_errors) {
  EXPECT_THROW(sentence_of({"no_such_form"}), std::logic_error);
  EXPECT_THROW(sentence_of({"sunk_beyond_limit", {{{"share", 0.1}}}}), std::logic_error);
}

TEST(Sentences, a_warning_keeps_its_values) {
  const Place place{"a.json", 3, 5};
  const Warning warning = warning_of({"step_cut:stays", {{{"step", 4}, {"time_step", 0.01}, {"dt", 0.005}}}}, place);
  EXPECT_EQ(warning.name, "step_cut");
  EXPECT_EQ(warning.place, place);
  EXPECT_EQ(warning.facts.numbers.size(), 3U);
  EXPECT_TRUE(warning.sentence.ends_with("the cut stays")) << warning.sentence;
}

}  // namespace keyblock::sentences_test
