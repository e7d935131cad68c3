// One kind of geometry made of another: what has no place in it is refused or named.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/derived_geometry.hpp"

#include <gtest/gtest.h>

#include "tests/support/two_triangles.hpp"

namespace keyblock::study {
namespace {

using formats::Content;

Content cover_of(Cover cover) {
  Content content;
  content.cover = std::move(cover);
  return content;
}

}  // namespace

TEST(DerivedGeometry, the_loops_of_a_cover_are_its_blocks) {
  const Derivation derived = as_blocks(cover_of(testing::two_triangles())).value();
  EXPECT_EQ(derived.from, "cover");
  EXPECT_EQ(derived.warnings, Warnings{});
  const Blocks& blocks = *derived.content.blocks;
  // The joint material of a loop's corner is that of the edge that leaves it, of a block's that of the edge that arrives.
  ASSERT_EQ(blocks.blocks.size(), 2U);
  EXPECT_EQ(blocks.blocks[0], (BlockPolygon{0, {{{0, 0}, 1}, {{1, 0}, 0}, {{1, 1}, 0}}, {}}));
  EXPECT_EQ(blocks.fixed_points.at(0).block, 0);
  EXPECT_EQ(blocks.loading_points.at(0).block, 1);
  EXPECT_EQ(blocks.measured_points.at(1).block, 1);
}

// Left out, it would hand its load to the next point.
TEST(DerivedGeometry, a_loading_point_outside_the_loops_is_refused) {
  Cover cover = testing::two_triangles();
  cover.loading_points.insert(cover.loading_points.begin(), {{5, 5}, 0, {"a.cv", 3, 1}});
  try {
    as_blocks(cover_of(cover));
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "a.cv:3:1: error: expected a loading point inside a block, found (5, 5) outside all loops of the cover");
  }
}

TEST(DerivedGeometry, other_points_outside_the_loops_are_left_out_with_a_warning) {
  Cover cover = testing::two_triangles();
  cover.fixed_points.insert(cover.fixed_points.begin(), {{5, 5}, 0, {}});
  const Derivation derived = as_blocks(cover_of(cover)).value();
  EXPECT_EQ(derived.content.blocks->fixed_points.size(), 1U);
  ASSERT_EQ(derived.warnings.size(), 1U);
  EXPECT_EQ(derived.warnings[0].name, "point_outside_blocks");
}

}  // namespace keyblock::study
