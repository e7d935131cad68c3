// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/columns/frame_columns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace keyblock::formats {
namespace {

/// A square with a hole and a triangle, of two materials.
Frame two_blocks() {
  Frame frame;
  ElementFrame& square = frame.elements.emplace_back();
  square.loops = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}};
  square.stress = {3, 1, 0, 0.5};
  square.displacement = {0.1, -0.2};
  ElementFrame& triangle = frame.elements.emplace_back();
  triangle.loops = {{{5, 0}, {6, 0}, {5, 1}}};
  triangle.material = 1;
  frame.fixed_points.resize(3);
  for (PointFrame& point : frame.fixed_points) point.element = 1;
  return frame;
}

}  // namespace

TEST(FrameColumns, blocks_loops_and_corners_fit_together) {
  const FrameColumns columns = columns_of(two_blocks(), {});
  const FramePart& blocks = columns.part("blocks");
  const FramePart& loops = columns.part("loops");
  const FramePart& corners = columns.part("corners");
  EXPECT_EQ(blocks.rows, 2U);
  EXPECT_EQ(std::vector<int>(loops.at("row").integers().begin(), loops.at("row").integers().end()),
            (std::vector{0, 0, 1}));
  EXPECT_EQ(std::vector<int>(loops.at("corners").integers().begin(), loops.at("corners").integers().end()),
            (std::vector{4, 4, 3}));
  EXPECT_EQ(corners.rows, 11U);
  EXPECT_EQ(corners.at("place").reals()[2 * 8], 5) << "first corner of the triangle";
  EXPECT_EQ(blocks.at("fixed_points").integers()[0], 0);
  EXPECT_EQ(blocks.at("fixed_points").integers()[1], 3);
  EXPECT_EQ(blocks.at("displacement").reals()[1], -0.2);
}

TEST(FrameColumns, a_part_without_rows_has_its_columns_and_an_unknown_name_is_refused) {
  const FrameColumns columns = columns_of(two_blocks(), {});
  EXPECT_EQ(columns.part("contacts").rows, 0U);
  EXPECT_TRUE(columns.part("contacts").at("normal_force").reals().empty());
  EXPECT_EQ(columns.part("blocks").find("colour"), nullptr);
  EXPECT_THROW(columns.part("blocks").at("colour"), std::invalid_argument);
  EXPECT_THROW(columns.part("clouds"), std::invalid_argument);
}

TEST(FrameColumns, derived_stress_and_strain_are_those_of_mohr_and_hooke) {
  std::vector<BlockMaterial> rocks(2);
  rocks[0].youngs_modulus = 100;
  rocks[0].poissons_ratio = 0.25;
  rocks[1] = rocks[0];
  const FrameColumns columns = with_derived(columns_of(two_blocks(), {}), rocks);
  const FramePart& blocks = columns.part("blocks");
  EXPECT_DOUBLE_EQ(blocks.at("principal_stress_greatest").reals()[0], 3);
  EXPECT_DOUBLE_EQ(blocks.at("principal_stress_least").reals()[0], 1);
  EXPECT_DOUBLE_EQ(std::abs(blocks.at("principal_axis").reals()[0]), 1) << "along x";
  const std::span<const double> strain = blocks.at("elastic_strain").reals();
  EXPECT_DOUBLE_EQ(strain[0], (3 - 0.25 * (1 + 0.5)) / 100);
  EXPECT_DOUBLE_EQ(strain[1], (1 - 0.25 * (3 + 0.5)) / 100);
  EXPECT_DOUBLE_EQ(strain[2], 0);
  EXPECT_DOUBLE_EQ(strain[3], (0.5 - 0.25 * (3 + 1)) / 100);
}

TEST(FrameColumns, copies_share_their_numbers) {
  const FrameColumns columns = columns_of(two_blocks(), {});
  const FrameColumn copy = columns.part("blocks").at("stress");
  EXPECT_EQ(copy.reals().data(), columns.part("blocks").at("stress").reals().data());
}

}  // namespace keyblock::formats
