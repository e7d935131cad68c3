// A scene requires only the terms it needs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setup/requirements.hpp"

#include <gtest/gtest.h>

#include "model/setup/choose_basis.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::requirements_test {
namespace {

using support::plain_analysis;
using support::rectangle;

Requirements needs_of(const Blocks& blocks, const Analysis& analysis) {
  return requirements(model_from_blocks(blocks, analysis), profile_settings("legacy", analysis));
}

Model two_on_floor(const Analysis& analysis, const Settings& settings) {
  Blocks blocks;
  blocks.blocks = {rectangle({-1, -1}, {5, 0}), rectangle({0, 0}, {1, 1}), rectangle({2, 0}, {3, 1})};
  blocks.fixed_points = {{{0, -0.5}, 0, {}}, {{4, -0.5}, 0, {}}};
  return with_bases(model_from_blocks(blocks, analysis), settings.basis);
}

std::vector<std::string> names(const Requirements& needs) {
  std::vector<std::string> all;
  for (const RequiredTerm& term : needs.terms) all.emplace_back(name_of(term.term));
  return all;
}

}  // namespace

TEST(Requirements, a_free_block_needs_no_contact_no_fixed_point_no_load) {
  const Requirements needs = needs_of({{rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}}, plain_analysis(1e-3, 1));
  EXPECT_EQ(needs.unknowns, 6);
  EXPECT_TRUE(needs.has(TermKind::body_force));
  EXPECT_FALSE(needs.has(TermKind::contact));
  EXPECT_FALSE(needs.has(TermKind::fixed_point));
  EXPECT_FALSE(needs.has(TermKind::point_load));
}

TEST(Requirements, a_loading_point_without_a_curve_is_no_load) {
  Analysis analysis = plain_analysis(1e-3, 1);
  const Blocks blocks{{rectangle({0, 0}, {1, 1})}, {}, {}, {{{0.5, 0.5}, 0, {}}}, {}, {}};
  EXPECT_FALSE(needs_of(blocks, analysis).has(TermKind::point_load));
  analysis.point_loads = {{{0, 1}, {{1, 0}, {1, 0}}, {}}};
  EXPECT_TRUE(needs_of(blocks, analysis).has(TermKind::point_load));
}

TEST(Requirements, without_gravity_there_is_no_body_force) {
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.gravity = 0;
  EXPECT_FALSE(needs_of({{rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}}, analysis).has(TermKind::body_force));
}

TEST(Requirements, damping_is_a_term_of_the_old_program_only_where_a_material_asks_for_it) {
  const Blocks blocks{{rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}};
  const Analysis analysis = plain_analysis(1e-3, 1);
  EXPECT_FALSE(needs_of(blocks, analysis).has(TermKind::damping));
  Settings settings = profile_settings("legacy", analysis);
  settings.mass_damping.own[0] = 1;
  EXPECT_TRUE(requirements(model_from_blocks(blocks, analysis), settings).has(TermKind::damping));
}

TEST(Requirements, a_rigid_frictionless_scene_needs_no_elasticity_damping_friction_or_bond) {
  const Analysis analysis = plain_analysis(1e-3, 1);
  Settings settings = profile_settings("standard", analysis);
  settings.basis = BlockBasis::rigid;
  const Requirements needs = requirements(two_on_floor(analysis, settings), settings);
  EXPECT_EQ(names(needs), (std::vector<std::string>{"inertia", "body_force", "contact", "impact", "start"}));
  EXPECT_EQ(needs.basis, "rigid, 3 unknowns each, for 2 blocks; fixed, none, for 1 block");
}

TEST(Requirements, an_affine_scene_with_strong_rough_joints_says_so) {
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.joint_materials[0] = {30, 1e4, 0, {}};
  analysis.block_materials[0].initial_stress = {1, 0, 0};
  const Settings settings = profile_settings("standard", analysis);
  const Requirements needs = requirements(two_on_floor(analysis, settings), settings);
  EXPECT_EQ(names(needs), (std::vector<std::string>{"inertia", "elastic", "initial_stress", "damping", "body_force",
                                                    "contact", "friction", "bond", "impact", "start"}));
}

TEST(Requirements, a_static_scene_of_the_standard_profile_has_neither_inertia_nor_damping_nor_impact) {
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.velocity_carry_over = 0;
  const Settings settings = profile_settings("standard", analysis);
  EXPECT_EQ(names(requirements(two_on_floor(analysis, settings), settings)),
            (std::vector<std::string>{"statics", "elastic", "body_force", "contact"}));
  const Requirements legacy = needs_of({{rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}}, analysis);
  EXPECT_TRUE(legacy.terms[0].reason.starts_with("static"));
}

}  // namespace keyblock::requirements_test
