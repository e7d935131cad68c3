// Losses name the difference, its place in a case file, its count, and the new value of the first.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/convert/losses.hpp"

#include <gtest/gtest.h>

namespace keyblock::study::losses_test {
namespace {

using formats::Content;
using Losses = std::vector<Loss>;

Content scene() {
  Content content;
  content.drawing.emplace().joints = {{{{0, 0}, {1, 0}}, 0, {}}, {{{1, 0}, {1, 1}}, 4, {}}};
  content.drawing->measured_points = {{{0.5, 0.5}, {}}};
  content.analysis.emplace().block_materials.resize(2);
  content.analysis->point_loads = {{{0}, {{1, 2}}, {}}};
  content.units = Units{"m", "t", "s"};
  return content;
}

}  // namespace

TEST(Losses, equal_contents_lose_nothing_and_a_dialect_is_no_loss) {
  Content other = scene();
  EXPECT_EQ(losses(scene(), other), Losses{});
  other.analysis->dialect = AnalysisDialect::shi;
  EXPECT_EQ(losses(scene(), other), Losses{});
  EXPECT_EQ(losses(Content{}, Content{}), Losses{});
}

TEST(Losses, a_value_is_named_by_its_column_and_counted) {
  Content other = scene();
  other.drawing->joints[0].joint_material = 2;
  other.drawing->joints[1].joint_material = 2;
  other.analysis->block_materials[1].stress_gradient.xy = -0.5;
  EXPECT_EQ(losses(scene(), other), (Losses{{"drawing.joints[].joint_material", 2, "1 → 3"},
                                            {"analysis.block_materials[].stress_gradient.xy", 1, "0 → -0.5"}}));
}

TEST(Losses, what_is_gone_or_came_is_said) {
  Content other = scene();
  other.units.reset();
  other.drawing->measured_points.clear();
  other.drawing->joints.pop_back();
  other.analysis->contact_penalty = 0.5;
  other.choices = RunChoices{"legacy", {}};
  EXPECT_EQ(losses(scene(), other), (Losses{{"units", 1, "{length, mass, time} → nothing"},
                                            {"drawing.joints", 1, "2 items → 1 item"},
                                            {"drawing.measured_points", 1, "1 item → nothing"},
                                            {"analysis.contact_penalty", 1, "nothing → 0.5", true},
                                            {"run", 1, "nothing → {profile}", true}}));
}

TEST(Losses, everything_is_lost_to_nothing_part_by_part) {
  EXPECT_EQ(losses(scene(), Content{}),
            (Losses{{"units", 1, "{length, mass, time} → nothing"},
                    {"drawing", 1, "{edge_node_ratio, boundary_count, joints, measured_points} → nothing"},
                    {"analysis", 1,
                     "{dialect, velocity_carry_over, step_count, time_step, "
                     "allowed_displacement_ratio, automatic_time_step and 9 more} → nothing"}}));
}

TEST(Losses, frames_and_tracks_are_counted) {
  Content one, two;
  one.frames.resize(2);
  one.tracks.resize(1);
  two.frames.resize(2);
  EXPECT_EQ(losses(one, two), (Losses{{"tracks", 1, "1 item → nothing"}}));
  two.frames[1].time = 0.5;
  EXPECT_EQ(losses(one, two).at(0), (Loss{"frames[].time", 1, "0 → 0.5"}));
  two.frames.pop_back();
  EXPECT_EQ(losses(one, two).at(0), (Loss{"frames", 1, "2 items → 1 item"}));
}

TEST(Losses, a_view_loses_the_items_it_leaves_out) {
  Content content = scene();
  content.frames.resize(3);
  content.frames[1].bolts.resize(2);
  const formats::LeftOut left_out{{"units", "drawing.joints[].joint_material", "frames[].bolts"}, 1};
  EXPECT_EQ(losses(content, left_out), (Losses{{"units", 1, "{length, mass, time} → not shown"},
                                               {"drawing.joints[].joint_material", 2, "1 → not shown"},
                                               {"frames[].bolts", 1, "2 items → not shown"},
                                               {"frames", 1, "3 items → the last 1"}}));
}

}  // namespace keyblock::study::losses_test
