// The energy picture draws what a scene has and leaves out what it has not.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/energy_picture.hpp"

#include <gtest/gtest.h>

namespace keyblock::report::energy_picture_test {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

Ledger falling() {
  Ledger ledger{{true, true, {}}, {{}, {}}};
  ledger.rows.back().time = 1;
  ledger.rows.back().stored.kinetic = 60;
  ledger.rows.back().stored.gravity = -100;
  ledger.rows.back().flow.friction = 40;
  return ledger;
}

}  // namespace

TEST(EnergyPicture, shows_the_energies_that_are_there) {
  const std::string svg = energy_picture("slope, energy", falling());
  for (const char* label : {"slope, energy", "kinetic", "gravity released", "dissipated", "</svg>"})
    EXPECT_TRUE(contains(svg, label)) << label;
  for (const char* label : {"strain", "contact springs", "work of loads"}) EXPECT_FALSE(contains(svg, label)) << label;
}

TEST(EnergyPicture, is_a_page_with_a_title_where_nothing_was_recorded) {
  EXPECT_TRUE(contains(energy_picture("empty", {}), "empty"));
}

}  // namespace keyblock::report::energy_picture_test
