// Settings by name: every one can be read and set, and a wrong one is refused with the expected values.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/settings_table.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "settings/profile.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::settings_table_test {

TEST(SettingsTable, every_setting_reads_back_what_it_shows) {
  const Settings given = profile_settings("legacy", support::plain_analysis(1e-3, 10));
  Settings copy;
  for (const SettingText& s : list(given)) set(copy, s.name, s.value);
  set(copy, "gravity.x", "1");
  set(copy, "gravity", "9.81");
  EXPECT_EQ(copy.gravity, (Point{0, -9.81}));
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
                                                                  {"time_step", "1e308"},
                                                                  {"gravity.x", "-1e155"},
                                                                  {"velocity_carry_over", "1.5"},
                                                                  {"rotation", "linear"},
                                                                  {"quirk.stale_contact_list", "true"},
                                                                  {"gravity", ""}})
    EXPECT_THROW(set(settings, name, value), std::invalid_argument) << name << "=" << value;
}

TEST(SettingsTable, materials_have_values_of_their_own_that_are_listed_where_given) {
  Settings settings = profile_settings("standard", support::plain_analysis(1e-3, 10));
  const std::size_t rows = list(settings).size();
  set(settings, "restitution", "0.5");
  set(settings, "restitution.2", "0.25");
  set(settings, "enforcement.1", "penalty");
  set(settings, "stiffness_damping.3", "1e-4");
  set(settings, "basis.1", "rigid");
  EXPECT_EQ(settings.standard.restitution.of(0), 0.5);
  EXPECT_EQ(settings.standard.restitution.of(1), 0.25);
  EXPECT_EQ(settings.standard.enforcement.of(0), Enforcement::penalty);
  EXPECT_EQ(settings.stiffness_damping.of(2), 1e-4);
  EXPECT_EQ(settings.stiffness_damping.of(0), std::nullopt);
  EXPECT_EQ(list(settings).size(), rows + 4);
  Settings copy;
  for (const SettingText& s : list(settings)) set(copy, s.name, s.value);
  EXPECT_EQ(copy.standard.restitution.own, settings.standard.restitution.own);
}

TEST(SettingsTable, a_word_that_is_gone_is_refused_with_what_takes_its_place) {
  Settings settings;
  try {
    set(settings, "motion", "relaxation");
    FAIL();
  } catch (const std::invalid_argument& refused) {
    EXPECT_STREQ(
        refused.what(),
        "setting motion: expected one of dynamic, static, found \"relaxation\"; static finds the equilibria that "
        "dynamic relaxation did");
  }
}

TEST(SettingsTable, numbers_that_name_no_material_are_refused) {
  Settings settings;
  for (const char* name : {"restitution.0", "restitution.x", "restitution.", "restitution.-1", "steps.1", "gravity.z"})
    EXPECT_THROW(set(settings, name, "1"), std::invalid_argument) << name;
  EXPECT_THROW(set(settings, "restitution.1", "2"), std::invalid_argument);
  set(settings, "mass_damping.3", "1");
  EXPECT_NO_THROW(require_materials(settings, 3, 1));
  try {
    require_materials(settings, 2, 9);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "setting mass_damping.3: expected a block material from 1 to 2, found \"3\"");
  }
}

TEST(SettingsTable, a_setting_knows_who_reads_it_and_what_it_may_be) {
  Settings shi;
  shi.dynamics = Dynamics::shi;
  Settings standard;
  standard.dynamics = Dynamics::standard;
  const char* kShi = "is read by dynamics shi alone";
  EXPECT_EQ(why_unread(standard, "pass_limit"), kShi);
  EXPECT_EQ(why_unread(standard, "quirk.cut_step_stays"), kShi);
  EXPECT_EQ(why_unread(shi, "quirk.cut_step_stays"), "");
  EXPECT_EQ(why_unread(standard, "quirk.weight_of_first_material"), "");
  EXPECT_EQ(why_unread(shi, "restitution.2"), "is read by dynamics standard alone");
  EXPECT_EQ(why_unread(shi, "steps"), "");
}

TEST(SettingsTable, choices_that_others_leave_unread_say_so) {
  const auto why = [](const std::string& name, const std::vector<std::pair<std::string, std::string>>& chosen) {
    Settings settings;
    settings.dynamics = Dynamics::standard;
    settings.step_control = StepControl::constant;
    for (const auto& [key, value] : chosen) set(settings, key, value);
    return why_unread(settings, name);
  };
  for (const char* of_newmark : {"newmark_beta", "newmark_gamma"}) {
    EXPECT_EQ(why(of_newmark, {}), "is read under integrator = newmark outside motion = static alone");
    EXPECT_EQ(why(of_newmark, {{"integrator", "newmark"}}), "");
    EXPECT_NE(why(of_newmark, {{"integrator", "newmark"}, {"motion", "static"}}), "");
  }
  EXPECT_EQ(why("velocity_weight", {}), "");
  EXPECT_NE(why("force_weight", {{"integrator", "generalized_alpha"}}), "");
  EXPECT_EQ(why("rho_infinity", {{"integrator", "generalized_alpha"}}), "");
  EXPECT_NE(why("rho_infinity", {{"integrator", "newmark"}}), "");
  EXPECT_EQ(why("load_steps", {}), "is read under motion = static alone");
  EXPECT_EQ(why("load_steps", {{"motion", "static"}}), "");
  EXPECT_EQ(why("start", {{"motion", "static"}}), "is read under motion = dynamic alone");
  EXPECT_EQ(why("step_tolerance", {{"step_control", "shi"}}), "is read under step_control = error alone");
  EXPECT_EQ(why("least_step_share", {{"step_control", "shi"}}), "");
  EXPECT_NE(why("least_step_share", {}), "");
  EXPECT_EQ(why("restitution.3", {{"impact", "springs"}}), "is read under impact = jump alone");
  for (const SettingText& s : list(Settings{})) EXPECT_FALSE(s.permitted.expected.empty()) << s.name;
}

TEST(SettingsTable, a_value_with_a_unit_is_converted_to_those_of_the_case) {
  const Units units{"mm", "t", "s"};
  const auto told = [&](const char* name, const char* value) {
    return in_units(units, name, value, measure_of_setting(name));
  };
  EXPECT_EQ(told("time_step", "2 ms"), "0.002");
  EXPECT_EQ(told("gravity", "9.81 m/s2"), "9810");
  EXPECT_EQ(told("contact_penalty", "20 MN/m/m"), "20");  // of a slice a mm thick: 2e7 N/m2 = 20 N/mm2
  EXPECT_EQ(told("time_step", "0.5"), "0.5");
  EXPECT_EQ(told("rotation", "exact"), "exact");
  EXPECT_EQ(told("no_such_setting", "2 ms"), "2 ms");
  EXPECT_EQ(told("steps", "10"), "10");
  EXPECT_THROW(told("time_step", "2 kN"), std::invalid_argument);
  EXPECT_THROW(in_units({}, "time_step", "2 ms", measures::kTime), std::invalid_argument);
}

}  // namespace keyblock::settings_table_test
