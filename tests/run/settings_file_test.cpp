// A file of settings comes back as it was written, and every fault is reported at its place.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/settings_file.hpp"

#include <gtest/gtest.h>

namespace keyblock::settings_file_test {
namespace {

std::string fault_of(const std::string& text) {
  try {
    read_settings("wish.settings", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

}  // namespace

TEST(SettingsFile, holds_a_profile_and_settings_in_order) {
  const SettingsFile file =
      read_settings("s", "# why\n\nprofile = draft\r\n  basis=rigid\ntime_step = 1e-3\nmesh.side = 2\n");
  EXPECT_EQ(file.profile, "draft");
  EXPECT_EQ(file.settings, (std::vector<Override>{{"basis", "rigid"}, {"time_step", "1e-3"}, {"mesh.side", "2"}}));
}

TEST(SettingsFile, comes_back_as_written) {
  const SettingsFile file{"reference", {{"restitution.2", "0.5"}, {"functions", "quadratic"}}};
  const SettingsFile again = read_settings("s", settings_text(file, "two\nlines"));
  EXPECT_EQ(again.profile, file.profile);
  EXPECT_EQ(again.settings, file.settings);
}

TEST(SettingsFile, faults_are_told_with_line_and_column) {
  EXPECT_EQ(fault_of("basis rigid\n"), "wish.settings:1:1: error: expected name = value, found \"basis rigid\"");
  EXPECT_EQ(fault_of("# so\n  = rigid\n"), "wish.settings:2:3: error: expected name = value, found \"= rigid\"");
  EXPECT_EQ(fault_of("profile = fast\n"),
            "wish.settings:1:11: error: expected a profile, one of legacy, draft, standard, reference, found \"fast\"");
  EXPECT_EQ(fault_of("steps = 2\nsteps = 3\n"),
            "wish.settings:2:1: error: expected each name once, found \"steps\" again");
  EXPECT_TRUE(fault_of(" bases = rigid\n")
                  .starts_with("wish.settings:1:2: error: there is no setting \"bases\"; did you mean \"basis\"?"));
  EXPECT_EQ(fault_of("basis =  soft\n"),
            "wish.settings:1:10: error: setting basis: expected one of rigid, affine, found \"soft\"");
  EXPECT_TRUE(
      fault_of("mesh.side = -1").starts_with("wish.settings:1:13: error: setting mesh.side: expected a length"));
  EXPECT_TRUE(fault_of("steps =").starts_with("wish.settings:1:8: error: setting steps: expected a whole number"));
}

}  // namespace keyblock::settings_file_test
