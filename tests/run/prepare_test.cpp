// A problem becomes a scene, or a message names what is missing; inputs without effect give a warning.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/prepare.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "run/cover_settings.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/two_triangles.hpp"

namespace keyblock::prepare_test {
namespace {

using support::plain_analysis;
using support::rectangle;

Blocks one_block() {
  Blocks blocks;
  blocks.blocks = {rectangle({0, 0}, {2, 1})};
  blocks.place = {"scene.blk", 0, 0};
  return blocks;
}

/// A square of four lines, cut in two.
Drawing two_halves() {
  Drawing drawing;
  drawing.edge_node_ratio = 0.01;
  for (const Segment& line : {Segment{{0, 0}, {2, 0}}, Segment{{2, 0}, {2, 2}}, Segment{{2, 2}, {0, 2}},
                              Segment{{0, 2}, {0, 0}}, Segment{{1, 0}, {1, 2}}})
    drawing.joints.push_back({line, 0, {}});
  return drawing;
}

Analysis analysis_of_file() {
  Analysis analysis = plain_analysis(1e-3, 10);
  analysis.place = {"scene.ana", 0, 0};
  return analysis;
}

std::string complaint(const Problem& problem) {
  try {
    prepare(problem, "legacy", {});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

std::vector<std::string> names(const Warnings& warnings) {
  std::vector<std::string> result;
  for (const Warning& w : warnings) result.push_back(w.name);
  std::ranges::sort(result);
  return result;
}

}  // namespace

TEST(Prepare, a_drawing_is_cut_and_blocks_are_taken_as_they_are) {
  const Prepared cut = prepare({two_halves(), analysis_of_file()}, "legacy", {});
  EXPECT_EQ(cut.blocks.blocks.size(), 2U);
  EXPECT_EQ(cut.scene.model.elements.size(), 2U);
  ASSERT_TRUE(cut.cut.has_value());
  EXPECT_EQ(cut.cut->lines, 5);
  const Prepared taken = prepare({one_block(), analysis_of_file()}, "legacy", {});
  EXPECT_EQ(taken.scene.model.elements.size(), 1U);
  EXPECT_FALSE(taken.cut.has_value());
}

TEST(Prepare, a_problem_without_geometry_or_analysis_names_the_file_that_stands_alone) {
  const std::string no_geometry = complaint({{}, analysis_of_file()});
  expect_contains(no_geometry, "scene.ana");
  expect_contains(no_geometry, "geometry");
  const std::string no_analysis = complaint({one_block(), {}});
  expect_contains(no_analysis, "scene.blk");
  expect_contains(no_analysis, "analysis");
  expect_contains(complaint({Blocks{}, analysis_of_file()}), "at least one block");
}

TEST(Prepare, motions_must_be_as_many_as_fixed_points) {
  Blocks blocks = one_block();
  blocks.fixed_points = {{{0, 0}, 0, {}}, {{2, 0}, 0, {}}};
  Analysis analysis = analysis_of_file();
  analysis.fixed_point_motions.resize(1);
  expect_contains(complaint({blocks, analysis}), "motions of the 2 fixed points of the geometry, found 1");
  analysis.fixed_point_motions.resize(2);
  EXPECT_EQ(complaint({blocks, analysis}), "");
}

TEST(Prepare, overrides_come_after_the_profile) {
  const Scene scene = prepare({one_block(), analysis_of_file()}, "legacy", {{"steps", "3"}, {"gravity", "0"}}).scene;
  EXPECT_EQ(scene.settings.step_count, 3);
  EXPECT_EQ(scene.settings.gravity, (Point{0, 0}));
  EXPECT_EQ(scene.settings.time_step, 1e-3);
  EXPECT_THROW(prepare({one_block(), analysis_of_file()}, "legacy", {{"no_such", "1"}}), std::invalid_argument);
}

TEST(Prepare, legacy_says_that_it_breaks_no_bolt) {
  Blocks blocks = one_block();
  blocks.bolts = {{{{0, 0}, {1, 0}}, 0, 0, 1e6, 0, 0}};
  EXPECT_TRUE(prepare({blocks, analysis_of_file()}, "legacy", {}).warnings.empty());
  blocks.bolts[0].strength = 5;
  EXPECT_EQ(names(prepare({blocks, analysis_of_file()}, "legacy", {}).warnings),
            (std::vector<std::string>{"bolt_strength_without_effect"}));
}

TEST(Prepare, a_bolt_that_its_pretension_breaks_is_warned_of) {
  Blocks blocks = one_block();
  blocks.bolts = {{{{0, 0}, {1, 0}}, 0, 0, 1e6, 0, 0}};
  blocks.bolts[0].strength = 20;
  blocks.bolts[0].pretension = 19;
  const auto warned = [&] { return names(prepare({blocks, analysis_of_file()}, "standard", {}).warnings); };
  EXPECT_EQ(std::ranges::count(warned(), "bolt_broken_at_start"), 0);
  blocks.bolts[0].pretension = 20;
  EXPECT_EQ(std::ranges::count(warned(), "bolt_broken_at_start"), 1);
}

TEST(Prepare, a_choice_for_a_material_that_is_not_there_is_refused) {
  EXPECT_NO_THROW(prepare({one_block(), analysis_of_file()}, "standard", {{"restitution.1", "0.5"}}));
  EXPECT_THROW(prepare({one_block(), analysis_of_file()}, "standard", {{"restitution.2", "0.5"}}),
               std::invalid_argument);
  EXPECT_THROW(prepare({one_block(), analysis_of_file()}, "legacy", {{"mass_damping.2", "0.5"}}),
               std::invalid_argument);
}

TEST(Prepare, what_is_read_but_has_no_effect_is_warned_of) {
  EXPECT_TRUE(prepare({one_block(), analysis_of_file()}, "legacy", {}).warnings.empty());
  Analysis analysis = analysis_of_file();
  analysis.contact_damping = 0.1;
  analysis.block_materials[0].damping = 0.1;
  EXPECT_EQ(names(prepare({one_block(), analysis}, "legacy", {}).warnings),
            (std::vector<std::string>{"contact_damping_without_effect", "damping_without_effect"}));
}

TEST(Prepare, horizontal_body_forces_are_warned_of_beside_blocks) {
  Analysis analysis = analysis_of_file();
  analysis.block_materials[0].horizontal_force = 1;
  EXPECT_EQ(names(prepare({one_block(), analysis}, "legacy", {}).warnings),
            (std::vector<std::string>{"horizontal_force_without_effect"}));
}

TEST(Prepare, a_cover_is_stepped_in_both_profiles) {
  Cover cover = support::two_triangles();
  cover.place = {"cv01", 0, 0};
  EXPECT_TRUE(can_prepare({cover, analysis_of_file()}));
  for (const char* profile : {"legacy", "standard"}) {
    const Prepared prepared = prepare({cover, analysis_of_file()}, profile, {});
    EXPECT_EQ(prepared.scene.model.elements.size(), 2U) << profile;
    EXPECT_EQ(prepared.requirements.unknowns, 12) << "two unknowns a cover, " << profile;
  }
  const Prepared quadratic = prepare({cover, analysis_of_file()}, "standard", {{"cover_functions", "quadratic"}});
  EXPECT_EQ(quadratic.requirements.unknowns, 72) << "twelve unknowns a cover";
}

TEST(Prepare, settings_that_do_not_go_together_are_refused) {
  const auto refused = [](const std::string& profile, const std::vector<Override>& overrides) {
    try {
      prepare({one_block(), analysis_of_file()}, profile, overrides);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refused("legacy", {{"step_control", "error"}}),
            "setting step_control: expected constant or shi under dynamics shi, found \"error\"");
  EXPECT_EQ(refused("standard", {{"step_control", "error"}}), "");
  EXPECT_EQ(refused("standard", {{"motion", "static"}, {"load_steps", "11"}}), "");
  EXPECT_EQ(refused("standard", {{"impact", "springs"}}), "");
  EXPECT_EQ(refused("standard", {{"impact", "springs"}, {"enforcement", "penalty"}}), "");
  for (const char* other : {"lagrange", "augmented"})
    EXPECT_EQ(refused("standard", {{"impact", "springs"}, {"enforcement.1", other}}),
              "setting impact: expected jump, or enforcement = penalty with springs, found \"springs\"");
}

TEST(Prepare, mistakes_of_the_old_step_do_not_belong_to_another_one) {
  const Settings mixed =
      prepare({one_block(), analysis_of_file()}, "legacy", {{"dynamics", "standard"}}).scene.settings;
  EXPECT_FALSE(mixed.quirks.velocity_from_coming_step);
  EXPECT_FALSE(mixed.quirks.step_rule_by_time);
  EXPECT_TRUE(mixed.quirks.weight_of_first_material);
}

TEST(Prepare, a_setting_that_the_chosen_dynamics_do_not_read_is_warned_of) {
  const auto told = [](const std::string& profile, const std::vector<Override>& overrides) {
    return names(prepare({one_block(), analysis_of_file()}, profile, overrides).warnings);
  };
  const std::vector<std::string> warned{"setting_without_effect"};
  EXPECT_EQ(told("legacy", {{"restitution.1", "0.5"}}), warned);
  EXPECT_EQ(told("standard", {{"pass_limit", "5"}}), warned);
  EXPECT_TRUE(told("standard", {{"restitution.1", "0.5"}, {"steps", "3"}}).empty());
  EXPECT_TRUE(told("legacy", {{"restitution.1", "0.5"}, {"dynamics", "standard"}}).empty());
  EXPECT_EQ(told("standard", {{"newmark_beta", "0.3"}}), warned);
  EXPECT_TRUE(told("standard", {{"newmark_beta", "0.3"}, {"integrator", "newmark"}}).empty());
  Problem with_choices{one_block(), analysis_of_file()};
  with_choices.choices.settings = {{"newmark_beta", "0.3"}};
  EXPECT_EQ(names(prepare(with_choices, "standard", {}).warnings), warned);
}

TEST(Prepare, values_of_overrides_may_have_a_unit_where_the_case_declares_its_own) {
  Problem problem{one_block(), analysis_of_file()};
  EXPECT_THROW(prepare(problem, "standard", {{"time_step", "2 ms"}}), std::invalid_argument);
  problem.units = {"mm", "t", "s"};
  const Settings settings =
      prepare(problem, "standard", {{"time_step", "2 ms"}, {"gravity", "9.81 m/s2"}}).scene.settings;
  EXPECT_EQ(settings.time_step, 0.002);
  EXPECT_EQ(settings.gravity, (Point{0, -9810}));
  problem.covers.emplace();
  const std::vector<Override> left = set_plan(problem, {{"mesh.side", "5 cm"}, {"time_step", "2 ms"}});
  EXPECT_EQ(problem.covers->mesh.side, 50);
  EXPECT_EQ(left.size(), 1U);
  EXPECT_THROW(set_plan(problem, {{"mesh.side", "5 s"}}), std::invalid_argument);
}

}  // namespace keyblock::prepare_test
