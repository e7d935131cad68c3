// The list of terms that a scene calls.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/assemble.hpp"

#include <gtest/gtest.h>

#include "tests/legacy/one_block.hpp"

namespace keyblock::assemble_test {
namespace {

using support::kBlock;
using support::legacy_scene;
using support::plain_analysis;

}  // namespace

// The list has no term that the scene does not need.
TEST(Assemble, only_required_terms_are_called) {
  EXPECT_EQ(legacy_scene(kBlock, plain_analysis(1e-3, 1)).terms.size(), 4U);
  Analysis weightless = plain_analysis(1e-3, 1);
  weightless.gravity = 0;
  EXPECT_EQ(legacy_scene(kBlock, weightless).terms.size(), 3U);
}

TEST(Assemble, is_the_sum_of_its_terms) {
  const ShiScene scene = legacy_scene(kBlock, plain_analysis(1e-3, 1));
  const State state = start(scene).state;
  const StepContext context{scene.model, state, scene.settings, 1e-3};
  const System whole = assemble(scene.terms, context);
  System sum = support::system_of_one_block();
  for (Term term : scene.terms) term(context, sum);
  EXPECT_EQ(whole.load, sum.load);
  EXPECT_EQ(whole.matrix.row(0)[0].block, sum.matrix.row(0)[0].block);
  EXPECT_NEAR(whole.load[1], -9.81 * 5000, 1e-8);
}

}  // namespace keyblock::assemble_test
