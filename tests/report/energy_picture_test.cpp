// The energy picture draws only the energies of the scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/energy_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace keyblock::report::energy_picture_test {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Their colours; a curve has a sign in the legend, too, which comes before all curves.
std::vector<std::string> curves_in(const std::string& svg) {
  std::vector<std::string> colours;
  const std::string stroke = "stroke=\"";
  for (std::size_t at = svg.find("<polyline"); at != std::string::npos; at = svg.find("<polyline", at + 1)) {
    const std::string shape = svg.substr(at, svg.find("/>", at) - at);
    if (!contains(shape, "stroke-width=\"2\"")) continue;
    const std::size_t colour = shape.find(stroke) + stroke.size();
    colours.push_back(shape.substr(colour, shape.find('"', colour) - colour));
  }
  std::vector<std::string> half;
  for (std::size_t i = 0; i < colours.size(); ++i)
    if (std::ranges::count(half, colours[i]) * 2 < std::ranges::count(colours, colours[i])) half.push_back(colours[i]);
  return half;
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

// Excavated rock takes its energy along: without that curve the picture would not balance.
TEST(EnergyPicture, changes_of_the_scene_have_a_curve) {
  Ledger ledger = falling();
  EXPECT_FALSE(contains(energy_picture("slope", ledger), "changes of the scene"));
  ledger.rows.back().flow.change = -30;
  EXPECT_TRUE(contains(energy_picture("slope", ledger), "changes of the scene"));
}

// A strain energy of 4 beside 100 is a flat line; in a panel of its own it reaches the upper tick, in the same colour.
TEST(EnergyPicture, energies_small_beside_the_others_have_a_panel_of_their_own) {
  Ledger ledger = falling();
  EXPECT_FALSE(contains(energy_picture("large alone", ledger), "below 5 %"));
  ledger.rows.back().stored.strain = 4;
  const std::string svg = energy_picture("large and small", ledger);
  EXPECT_TRUE(contains(svg, "below 5 % of the greatest"));
  EXPECT_TRUE(contains(svg, ">100</text>"));
  EXPECT_TRUE(contains(svg, ">4.0</text>") || contains(svg, ">4</text>"));
  const std::string first = svg.substr(0, svg.find("below 5 %"));
  const std::string second = svg.substr(first.size());
  EXPECT_EQ(curves_in(first).size(), 4U);  // kinetic, strain, gravity, losses
  ASSERT_EQ(curves_in(second).size(), 1U);
  EXPECT_EQ(curves_in(second)[0], curves_in(first)[1]);

  // A thousandth of the strain energy is read in a third panel; round-off has none.
  ledger.rows.back().stored.contact = 0.004;
  ledger.rows.back().flow.external = 1e-9;
  const std::string three = energy_picture("three sizes", ledger);
  const std::string third = three.substr(three.rfind("below 5 %"));
  EXPECT_EQ(curves_in(three).size(), 6U + 2U + 1U);
  EXPECT_EQ(curves_in(third).size(), 1U);
  EXPECT_TRUE(contains(third, "contact springs"));

  ledger.rows.back().stored.contact = 0;
  ledger.rows.back().stored.strain = 6;
  EXPECT_FALSE(contains(energy_picture("none small", ledger), "below 5 %"));
}

// A scale of its own would show the round-off of a constant energy.
TEST(EnergyPicture, a_small_energy_that_stays_has_no_panel) {
  Ledger ledger = falling();
  ledger.rows.front().stored.strain = 0.125115998262;
  ledger.rows.back().stored.strain = 0.125115998263;
  EXPECT_FALSE(contains(energy_picture("block at rest", ledger), "below 5 %"));
}

TEST(EnergyPicture, is_a_page_with_a_title_where_nothing_was_recorded) {
  EXPECT_TRUE(contains(energy_picture("empty", {}), "empty"));
}

}  // namespace keyblock::report::energy_picture_test
