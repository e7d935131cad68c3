// Joints of a drawing that end inside blocks: cracks of NMM bodies, without effect on DDA blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "formats/case.hpp"
#include "formats/registry.hpp"
#include "model/continuum.hpp"
#include "run/prepare.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::joints_inside_test {
namespace {

/// Two blocks beside each other, the right one of material 2 and on covers; `joints` more than their outlines.
Prepared two_blocks(const std::string& joints, const std::vector<Override>& overrides = {}) {
  const std::string file = support::fresh_folder("joints_inside") + "/in.json";
  support::write_text(file, R"({"keyblock": 2, "drawing": {"edge_node_ratio": 0.001, "boundary_count": 4, "joints": [
      [0, 0, 4, 0, 1], [4, 0, 4, 2, 1], [4, 2, 0, 2, 1], [0, 2, 0, 0, 1], [2, 0, 2.02, 2, 1])" +
                                joints + R"(],
      "material_lines": [[3, 0.2, 3.1, 0.2, 2]], "fixed_lines": [[0.01, 0.01, 3.99, 0.01]]},
    "covers": {"mesh": {"side": 0.5, "materials": [[2]]}},
    "analysis": {"step_count": 2, "time_step": 1e-3, "joint_materials": [{"friction_angle_deg": 30}],
      "block_materials": [{"density": 2000, "youngs_modulus": 1e9, "poissons_ratio": 0.2},
        {"density": 2000, "youngs_modulus": 1e9, "poissons_ratio": 0.2}]}})");
  return prepare(formats::load_case({file}).problem, "standard", overrides);
}

std::size_t tips(const Prepared& prepared) {
  return prepared.scene.model.continuum->manifold.tips.size();
}

bool warns(const Prepared& prepared) {
  for (const Warning& warning : prepared.warnings)
    if (warning.name == "dangling_lines_removed") return true;
  return false;
}

}  // namespace

TEST(JointsInside, of_a_block_on_covers_are_cracks) {
  const Prepared whole = two_blocks("");
  EXPECT_EQ(tips(whole), 0u);
  for (const char* joint : {", [4, 1, 3, 1.1, 1]", ", [3, 1, 2.01, 1.1, 1]", ", [3.3, 2, 2.9, 0.8, 1]"}) {
    const Prepared made = two_blocks(joint);
    ASSERT_EQ(tips(made), 1u) << joint;
    EXPECT_FALSE(warns(made)) << joint;
    EXPECT_EQ(made.scene.model.continuum->manifold.body_materials.size(), 1u) << joint;
  }
  EXPECT_EQ(tips(two_blocks(", [2.6, 0.9, 3.4, 1.2, 1]")), 2u) << "on no other line";
  EXPECT_EQ(tips(two_blocks(", [4, 1, 3, 1.1, 1], [2.8, 0.7, 3.7, 1.6, 1]")), 3u) << "they cross";
  const Prepared parted = two_blocks(", [4, 1, 3, 1.1, 1], [3.5, 0, 3.5, 1.6, 1]");
  EXPECT_EQ(tips(parted), 2u) << "they cross and part a block, from whose corner both go on";
}

TEST(JointsInside, of_a_block_that_stays_one_are_removed_and_told) {
  const Prepared made = two_blocks(", [0, 1, 1, 1.1, 1]");
  EXPECT_EQ(tips(made), 0u);
  EXPECT_TRUE(warns(made));
  const Prepared through = two_blocks(", [1, 1, 3, 1.3, 1]");
  EXPECT_EQ(tips(through), 1u) << "a part in either";
  EXPECT_TRUE(warns(through));
}

TEST(JointsInside, what_goes_beyond_the_outline_is_no_joint_inside) {
  const Prepared made = two_blocks(", [-0.1, 1, 4.1, 1.2, 1]");
  EXPECT_EQ(tips(made), 0u);
  EXPECT_FALSE(warns(made));
}

// The outline between a sliver and its neighbour is gone: the joint that crosses it continues as one.
TEST(JointsInside, cross_an_outline_that_a_glued_sliver_had) {
  EXPECT_EQ(tips(two_blocks(", [3.984375, 0, 3.984375, 2, 1], [3.9921875, 1, 3, 1, 1]", {{"slivers", "glue"}})), 2u);
}

}  // namespace keyblock::joints_inside_test
