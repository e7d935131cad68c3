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

}  // namespace keyblock
