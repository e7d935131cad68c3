// A profile takes its choices from the analysis file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/profile.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>

#include "tests/support/scenes.hpp"

namespace keyblock::profile_test {

TEST(Profile, penalty_is_the_factor_times_the_greatest_modulus_unless_the_file_gives_one) {
  Analysis analysis = support::plain_analysis(1e-3, 1);
  analysis.penalty_factor = 40;
  EXPECT_EQ(profile_settings("legacy", analysis).contact_penalty, 40 * 5e9);
  analysis.contact_penalty = 7e8;
  EXPECT_EQ(profile_settings("legacy", analysis).contact_penalty, 7e8);
  analysis.contact_penalty = 0;  // "program chooses" in Shi's dialect
  EXPECT_EQ(profile_settings("legacy", analysis).contact_penalty, 40 * 5e9);
}

TEST(Profile, gravity_of_native_files_is_that_of_the_first_material) {
  Analysis analysis = support::plain_analysis(1e-3, 1);
  analysis.gravity.reset();
  EXPECT_DOUBLE_EQ(-profile_settings("legacy", analysis).gravity.y, 9.81);
}

// Shi's dialects name start velocity and stress gradient apart and weigh each material by itself.
TEST(Profile, quirks_of_berkeley_material_slots_are_off_in_shis_dialects) {
  Analysis analysis = support::plain_analysis(1e-3, 1);
  EXPECT_TRUE(profile_settings("legacy", analysis).quirks.start_velocity_slots);
  EXPECT_TRUE(profile_settings("legacy", analysis).quirks.weight_of_first_material);
  for (const AnalysisDialect dialect : {AnalysisDialect::shi, AnalysisDialect::manifold}) {
    analysis.dialect = dialect;
    EXPECT_FALSE(profile_settings("legacy", analysis).quirks.start_velocity_slots);
    EXPECT_FALSE(profile_settings("legacy", analysis).quirks.weight_of_first_material);
  }
}

TEST(Profile, manifold_files_are_taken_at_their_word_for_step_and_stiffness) {
  Analysis analysis = support::plain_analysis(1e-3, 1);
  analysis.dialect = AnalysisDialect::manifold;
  analysis.automatic_time_step = true;
  analysis.automatic_penalty = true;
  const Settings settings = profile_settings("legacy", analysis);
  EXPECT_EQ(settings.step_control, StepControl::constant);
  EXPECT_EQ(settings.penalty_control, PenaltyControl::constant);
  EXPECT_FALSE(settings.quirks.velocity_from_coming_step);
}

TEST(Profile, a_name_that_is_none_is_refused) {
  EXPECT_THROW(profile_settings("modern", support::plain_analysis(1e-3, 1)), std::invalid_argument);
}

TEST(Profile, draft_and_reference_take_the_time_of_the_file_in_other_steps) {
  Analysis analysis = support::plain_analysis(1e-3, 1000);
  const Settings standard = profile_settings("standard", analysis);
  const Settings draft = profile_settings("draft", analysis);
  const Settings reference = profile_settings("reference", analysis);
  EXPECT_EQ(draft.step_count, 500);
  EXPECT_DOUBLE_EQ(draft.time_step, 2e-3);
  EXPECT_EQ(reference.step_count, 4000);
  EXPECT_DOUBLE_EQ(reference.time_step, 2.5e-4);
  EXPECT_EQ(standard.step_count, 1000);
  analysis.step_count = 3;
  EXPECT_EQ(profile_settings("draft", analysis).step_count, 2);
  EXPECT_DOUBLE_EQ(profile_settings("draft", analysis).time_step, 1.5e-3);
  analysis.velocity_carry_over = 0;  // statics: no time to be divided
  EXPECT_EQ(profile_settings("draft", analysis).step_count, 3);
  EXPECT_EQ(profile_settings("reference", analysis).step_count, 3);
}

TEST(Profile, draft_and_reference_take_their_share_of_steps_that_are_set_too) {
  const Analysis analysis = support::plain_analysis(1e-3, 1000);
  const auto set_both = [](Settings& settings) {
    settings.step_count = 100;
    settings.time_step = 0.01;
  };
  EXPECT_EQ(profile_settings("standard", analysis, set_both).step_count, 100);
  for (const auto& [name, steps] : {std::pair{"draft", 50}, {"reference", 400}}) {
    const Settings settings = profile_settings(name, analysis, set_both);
    EXPECT_EQ(settings.step_count, steps);
    EXPECT_DOUBLE_EQ(settings.step_count * settings.time_step, 1);
  }
}

TEST(Profile, cases_know_draft_and_reference_as_standard) {
  EXPECT_EQ(rules_of("draft"), "standard");
  EXPECT_EQ(rules_of("reference"), "standard");
  EXPECT_EQ(rules_of("legacy"), "legacy");
  EXPECT_THROW(rules_of("fast"), std::invalid_argument);
}

}  // namespace keyblock::profile_test
