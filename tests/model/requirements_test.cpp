// A scene is asked only for the terms it needs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/requirements.hpp"

#include <gtest/gtest.h>

#include "tests/support/scenes.hpp"

namespace keyblock {
namespace {

using testing::plain_analysis;
using testing::rectangle;

Requirements needs_of(const Blocks& blocks, const Analysis& analysis) {
  return requirements(model_from_blocks(blocks, analysis), profile_settings("legacy", analysis));
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

}  // namespace keyblock
