// Warnings of a plan and of a run carry the numbers, blocks and points of their sentences.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>

#include "api/case_folder.hpp"
#include "tests/library/example_cases.hpp"

namespace keyblock::api_test {
namespace {

using Points = std::vector<std::array<double, 2>>;

/// Returns the facts of the only warning with this code.
kb::Facts facts_of(const std::vector<kb::Warning>& warnings, std::string_view code) {
  EXPECT_EQ(std::ranges::count(warnings, code, &kb::Warning::code), 1) << code;
  const auto found = std::ranges::find(warnings, code, &kb::Warning::code);
  return found == warnings.end() ? kb::Facts{} : found->facts;
}

kb::Facts facts_of(const kb::Case& of, std::string_view code) {
  return facts_of(kb::Plan(of).warnings(), code);
}

double number(const kb::Facts& facts, std::string_view name) {
  const auto found = std::ranges::find(facts.numbers, name, &std::pair<std::string, double>::first);
  return found == facts.numbers.end() ? std::nan("") : found->second;
}

/// Gives a block of a wall another outline, from left and bottom.
kb::Case with_block(const kb::Case& of, int number, double left, double bottom, double right, double top) {
  const std::string block = rectangle(left, bottom, right, top);
  const std::size_t begin = block.find("[[");
  return of.with("/blocks/blocks/" + std::to_string(number - 1) + "/outer",
                 block.substr(begin, block.size() - 1 - begin));
}

}  // namespace

TEST(FactsOfWarnings, blocks_that_nothing_holds) {
  const kb::Facts facts = facts_of(wall(2, 1, false), "unheld_blocks");
  EXPECT_EQ(facts.blocks, (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(number(facts, "count"), 3);
  EXPECT_EQ(number(facts, "blocks"), 3);
  EXPECT_NEAR(number(facts, "area"), 4, 1e-9) << "the floor, 4 by 1";
  EXPECT_NEAR(number(facts, "percent_of_mean"), 100 * 4 / (5.0 / 3), 1e-9);
  ASSERT_EQ(facts.points.size(), 1U);
  EXPECT_NEAR(facts.points.front()[0], 1, 1e-9);
  EXPECT_NEAR(facts.points.front()[1], -0.5, 1e-9);
}

TEST(FactsOfWarnings, a_block_without_contact) {
  const kb::Facts facts = facts_of(with_block(wall(2, 1), 3, 1, 2, 2, 2.5), "free_blocks");
  EXPECT_EQ(facts.blocks, std::vector<int>{3});
  EXPECT_EQ(number(facts, "count"), 1);
  EXPECT_NEAR(number(facts, "area"), 0.5, 1e-9);
  ASSERT_EQ(facts.points.size(), 1U);
  EXPECT_NEAR(facts.points.front()[1], 2.25, 1e-9);
}

TEST(FactsOfWarnings, slivers_with_the_smallest_first) {
  const kb::Case thin = with_block(with_block(wall(2, 1), 2, 0, 0, 1, 0.002), 3, 1, 0, 2, 0.001);
  const kb::Facts facts = facts_of(thin, "slivers");
  EXPECT_EQ(facts.blocks, (std::vector<int>{3, 2}));
  EXPECT_EQ(number(facts, "thinnest"), 3);
  EXPECT_NEAR(number(facts, "width"), 0.001, 1e-5);
  EXPECT_NEAR(number(facts, "area"), 0.001, 1e-9);
  ASSERT_EQ(facts.points.size(), 2U);
  EXPECT_NEAR(facts.points.back()[0], 1.5, 1e-9);
}

TEST(FactsOfWarnings, strength_between_faces_that_are_drawn_apart) {
  const kb::Case strong = wall(1, 1).with("/analysis/joint_materials/0/cohesion", 1e5);
  kb::Facts facts = facts_of(with_block(strong, 2, 0, 0.004, 1, 0.5), "strength_without_bond");
  std::ranges::sort(facts.blocks);
  EXPECT_EQ(facts.blocks, (std::vector<int>{1, 2}));
  EXPECT_EQ(number(facts, "cohesion"), 1e5);
  EXPECT_EQ(number(facts, "joint_material"), 1);
  EXPECT_EQ(number(facts, "count"), 1);
  EXPECT_NEAR(number(facts, "apart"), 0.004, 1e-9);
  ASSERT_EQ(facts.points.size(), 1U);
  EXPECT_NEAR(facts.points.front()[1], 0.002, 0.0021);
}

TEST(FactsOfWarnings, values_in_another_unit) {
  const kb::Facts angle =
      facts_of(wall(1, 1).with("/analysis/joint_materials/0/friction_angle_deg", 0.5), "angle_in_radians");
  EXPECT_EQ(number(angle, "angle"), 0.5);
  EXPECT_NEAR(number(angle, "meant"), 0.5 * 180 / std::numbers::pi, 1e-12);
  const kb::Facts density =
      facts_of(wall(1, 1).with("/analysis/block_materials/0/density", 25.0), "implausible_density");
  EXPECT_EQ(number(density, "value"), 25);
  EXPECT_NEAR(number(density, "of_rock"), 25000 / 9.81, 1e-9);
}

TEST(FactsOfWarnings, histories_of_blocks_that_are_far_apart) {
  kb::Run run(kb::Plan(wall(6, 1), {"", {}, {"ends=contact:2,7"}}));
  const std::vector<kb::Warning>& warnings = run.go_on().warnings;
  for (const char* code : {"history_of_distant_blocks", "history_of_nothing"}) {
    const kb::Facts facts = facts_of(warnings, code);
    EXPECT_EQ(facts.blocks, (std::vector<int>{2, 7})) << code;
    EXPECT_NEAR(number(facts, "apart"), 4, 1e-9) << code;
  }
}

TEST(FactsOfWarnings, lines_that_are_drawn_twice_and_defaults) {
  const kb::Case square = case_of(R"({"keyblock": 2, "drawing": {"edge_node_ratio": 0.001, "boundary_count": 4,
  "joints": [[0, 0, 2, 0, 1], [2, 0, 2, 2, 1], [2, 2, 0, 2, 1], [0, 2, 0, 0, 1], [2, 2, 2, 0, 1], [1, 0, 3, 0, 1]],
  "fixed_lines": [[0.5, 0.5, 0.5, 0.5]]},
 "analysis": {"step_count": 1, "time_step": 0.01,
  "block_materials": [{"density": 2500, "youngs_modulus": 1e9, "poissons_ratio": 0.2}],
  "joint_materials": [{"friction_angle_deg": 30}]}})");
  const std::vector<kb::Warning> warnings = kb::Plan(square).warnings();
  kb::Facts facts = facts_of(warnings, "duplicate_line");
  EXPECT_EQ(number(facts, "line"), 5);
  EXPECT_EQ(number(facts, "count"), 1);
  facts = facts_of(warnings, "overlapping_lines");
  EXPECT_EQ(number(facts, "line"), 6);
  EXPECT_EQ(number(facts, "other_line"), 1);
  ASSERT_EQ(facts.points.size(), 1U);
  EXPECT_EQ(facts.points.front()[1], 0);
  EXPECT_NEAR(number(facts_of(warnings, "defaults_taken"), "gravity"), 9.81, 1e-12);
}

TEST(FactsOfWarnings, names_of_settings_and_layers) {
  const kb::Facts setting =
      facts_of(kb::Plan(wall(1, 1), {"", {{"cover_functions", "constant"}}}).warnings(), "setting_without_effect");
  using Names = std::vector<std::pair<std::string, std::string>>;
  EXPECT_EQ(setting.names, (Names{{"setting", "cover_functions"}}));
  const std::string docs = std::string(KEYBLOCK_SOURCE_DIR) + "/docs/";
  const kb::Case quarry = kb::Case::read({docs + "quarry.dxf", docs + "bench.json"}, {});
  std::vector<std::string> layers;
  for (const kb::Warning& warning : quarry.warnings())
    if (warning.code == "dxf_layer_as_joints") {
      EXPECT_EQ(warning.facts.names.front().first, "layer");
      EXPECT_GE(number(warning.facts, "joint_material"), 1);
      layers.push_back(warning.facts.names.front().second);
    }
  EXPECT_NE(std::ranges::find(layers, "Bedding"), layers.end());
}

// A sentence with a number that no value stands behind would have to be read by programs.
TEST(FactsOfWarnings, whatever_has_a_number_has_values) {
  int with_values = 0;
  const std::vector<CaseFolder> cases = find_cases({std::string(KEYBLOCK_SOURCE_DIR) + "/legacy_cases"});
  for (std::size_t i = 0; i < cases.size(); i += 5) {
    const kb::Plan plan(kb::Case::read({cases[i].folder.string()}));
    for (const kb::Warning& warning : plan.warnings()) {
      if (std::ranges::none_of(warning.sentence, [](unsigned char c) { return std::isdigit(c) != 0; })) continue;
      const kb::Facts& facts = warning.facts;
      EXPECT_FALSE(facts.numbers.empty() && facts.blocks.empty() && facts.points.empty() && facts.names.empty())
          << cases[i].folder << ": " << warning.code << ": " << warning.sentence;
      ++with_values;
    }
  }
  EXPECT_GT(with_values, 15);
}

}  // namespace keyblock::api_test
