// Pictures of blocks show every block, joint material and point, also of irregular scenes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/blocks_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <pugixml.hpp>

namespace keyblock::report::blocks_picture_test {
namespace {

BlockPolygon square(double x, double y, int material) {
  return {material, {{{x, y}, 0}, {{x + 1, y}, 1}, {{x + 1, y + 1}, 0}, {{x, y + 1}, 1}}, {}};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

bool is_well_formed(const std::string& picture) {
  return pugi::xml_document{}.load_string(picture.c_str());
}

}  // namespace

TEST(BlocksPicture, legend_names_the_materials_and_points_present) {
  Blocks blocks;
  blocks.blocks = {square(0, 0, 0), square(1, 0, 2)};
  blocks.fixed_points = {{{0.5, 0.5}, 0, {}}};
  const std::string picture = blocks_picture(blocks);
  EXPECT_TRUE(is_well_formed(picture));
  for (const char* words :
       {">2 blocks<", ">block material 1<", ">block material 3<", ">joint material 2<", ">fixed points (1)<"})
    EXPECT_EQ(count(picture, words), 1U) << words;
  EXPECT_EQ(count(picture, "loading points"), 0U);
}

TEST(BlocksPicture, holes_are_drawn_as_holes) {
  Blocks blocks;
  blocks.blocks = {square(0, 0, 0)};
  blocks.blocks[0].holes = {{{{0.2, 0.2}, 0}, {{0.2, 0.4}, 0}, {{0.4, 0.4}, 0}}};
  EXPECT_EQ(count(blocks_picture(blocks), "ZM"), 1U);
}

TEST(BlocksPicture, no_block_a_far_origin_and_bad_coordinates_give_a_page) {
  Blocks blocks;
  EXPECT_TRUE(is_well_formed(blocks_picture(blocks)));
  blocks.blocks = {square(1e7, -1e7, 0)};
  EXPECT_TRUE(is_well_formed(blocks_picture(blocks)));
  blocks.blocks.push_back(square(std::numeric_limits<double>::quiet_NaN(), 0, 0));
  const std::string picture = blocks_picture(blocks);
  EXPECT_TRUE(is_well_formed(picture));
  EXPECT_EQ(count(picture, "nan"), 0U);
}

}  // namespace keyblock::report::blocks_picture_test
