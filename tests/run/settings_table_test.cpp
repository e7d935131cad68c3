// Settings by name: every one can be read and set, and a wrong one is refused with what was expected.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/settings_table.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "run/profile.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock {

TEST(SettingsTable, every_setting_reads_back_what_it_shows) {
  const Settings given = profile_settings("legacy", testing::plain_analysis(1e-3, 10));
  Settings copy;
  for (const SettingText& s : list(given)) set(copy, s.name, s.value);
  const std::vector<SettingText> expected = list(given);
  const std::vector<SettingText> found = list(copy);
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(found[i].value, expected[i].value) << expected[i].name;
}

TEST(SettingsTable, wrong_names_and_values_are_refused) {
  Settings settings;
  EXPECT_THROW(set(settings, "no_such_setting", "1"), std::invalid_argument);
  for (const auto& [name, value] :
       std::initializer_list<std::pair<const char*, const char*>>{{"steps", "0"},
                                                                  {"steps", "1.5"},
                                                                  {"steps", "2x"},
                                                                  {"time_step", "0"},
                                                                  {"time_step", "nan"},
                                                                  {"velocity_carry_over", "1.5"},
                                                                  {"rotation", "linear"},
                                                                  {"quirk.stale_contact_list", "true"},
                                                                  {"gravity", ""}})
    EXPECT_THROW(set(settings, name, value), std::invalid_argument) << name << "=" << value;
}

TEST(Profile, penalty_is_the_factor_times_the_greatest_modulus_unless_the_file_gives_one) {
  Analysis analysis = testing::plain_analysis(1e-3, 1);
  analysis.penalty_factor = 40;
  EXPECT_EQ(profile_settings("legacy", analysis).contact_penalty, 40 * 5e9);
  analysis.contact_penalty = 7e8;
  EXPECT_EQ(profile_settings("legacy", analysis).contact_penalty, 7e8);
  analysis.contact_penalty = 0;  // "program chooses" in Shi's dialect
  EXPECT_EQ(profile_settings("legacy", analysis).contact_penalty, 40 * 5e9);
}

TEST(Profile, gravity_of_native_files_is_that_of_the_first_material) {
  Analysis analysis = testing::plain_analysis(1e-3, 1);
  analysis.gravity.reset();
  EXPECT_DOUBLE_EQ(profile_settings("legacy", analysis).gravity, 9.81);
}

TEST(Profile, a_name_that_is_none_is_refused) {
  EXPECT_THROW(profile_settings("modern", testing::plain_analysis(1e-3, 1)), std::invalid_argument);
}

}  // namespace keyblock
