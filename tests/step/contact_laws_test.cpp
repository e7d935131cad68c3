// Failure of a bonded face, in shear and in bending: its points fail together, not one by one.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/contact_laws.hpp"

#include <gtest/gtest.h>

#include "tests/support/standard_scenes.hpp"

namespace keyblock::contact_laws_test {
namespace {

// A square of 1 on a floor: a face with a point at each end. c L = 100, T L = 60, friction 0.5.
class BondedFaceOfTwoPoints : public ::testing::Test {
 protected:
  bool is_overloaded(const Eigen::Vector4d& forces) const {
    Touches ends(2);
    for (int end : {0, 1}) {
      ends[static_cast<std::size_t>(end)].vertex = VertexIndex{4 + end};
      ends[static_cast<std::size_t>(end)].start = VertexIndex{2};
      ends[static_cast<std::size_t>(end)].end = VertexIndex{3};
      ends[static_cast<std::size_t>(end)].facing = {{2}, {4}, end};
    }
    ContactLaw law;
    law.is_bonded = true;
    law.force.friction = 0.5;
    law.force.least = -30;
    law.shear_strength = 50;
    law.bonded_length = 0.5;
    const Motion motion = start_motion(scene_);
    const std::size_t count = overloaded_faces(scene_, motion.q, ends, {law, law}, forces, 1e-9).size();
    EXPECT_TRUE(count == 0 || count == 2);
    return count == 2;
  }

 private:
  static StandardScene square_on_floor() {
    const Analysis analysis = support::plain_analysis(1e-3, 1);
    return standard_scene(
        support::standard_scene_of(support::block_on_slope(0), analysis, support::standard_settings(analysis)));
  }

  StandardScene scene_ = square_on_floor();
};

}  // namespace

TEST_F(BondedFaceOfTwoPoints, holds_the_shear_that_its_points_hold_together) {
  EXPECT_FALSE(is_overloaded({0, 99, 0, 0}));
  EXPECT_FALSE(is_overloaded({40, 119, 0, 0}));  // 100 + 0.5 · 40
  EXPECT_FALSE(is_overloaded({0, 300, 0, -300}));
}

TEST_F(BondedFaceOfTwoPoints, loses_all_its_bonds_beyond_its_strength) {
  EXPECT_TRUE(is_overloaded({0, 101, 0, 0}));
  EXPECT_TRUE(is_overloaded({0, -60, 0, -60}));
  EXPECT_TRUE(is_overloaded({-5, 98, 0, 0}));  // pulled: 100 − 0.5 · 5
}

// A moment M tears it at 6 M/L² = T, where its ends carry T L/6; under a thrust that meets the face it opens in part.
TEST_F(BondedFaceOfTwoPoints, tears_at_the_stress_of_a_beam) {
  EXPECT_FALSE(is_overloaded({9.9, 0, -9.9, 0}));
  EXPECT_TRUE(is_overloaded({10.1, 0, -10.1, 0}));
  EXPECT_FALSE(is_overloaded({-29.9, 0, -29.9, 0}));
  EXPECT_TRUE(is_overloaded({40, 0, -1, 0}));
  EXPECT_FALSE(is_overloaded({400, 0, 0, 0}));
}

}  // namespace keyblock::contact_laws_test
