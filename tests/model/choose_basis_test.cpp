// Blocks that move, and the number of their unknowns.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setup/choose_basis.hpp"

#include <gtest/gtest.h>

#include "model/setup/requirements.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::choose_basis_test {
namespace {

using support::rectangle;

Model four_blocks() {
  Blocks blocks;
  for (double x : {0.0, 2.0, 4.0, 6.0}) blocks.blocks.push_back(rectangle({x, 0}, {x + 1, 1}));
  blocks.fixed_points = {{{0.1, 0.5}, 0, {}}, {{0.9, 0.5}, 0, {}},   // two places: fixed
                         {{2.5, 0.5}, 1, {}}, {{2.5, 0.5}, 1, {}},   // one place twice: may rotate
                         {{4.1, 0.5}, 2, {}}, {{4.9, 0.5}, 2, {}}};  // driven
  Analysis analysis = support::plain_analysis(1, 1);
  analysis.fixed_point_motions.resize(6);
  analysis.fixed_point_motions[5] = {{0, 1}, {{0, 0}, {1, 0}}, {}};
  return model_from_blocks(blocks, analysis);
}

std::vector<int> unknowns(const Model& model) {
  std::vector<int> counts;
  for (const Element& element : model.elements) counts.push_back(element.basis->unknown_count());
  return counts;
}

}  // namespace

TEST(ChooseBasis, blocks_held_at_two_places_are_fixed_and_the_others_are_as_asked) {
  EXPECT_EQ(unknowns(with_bases(four_blocks(), BlockBasis::rigid)), (std::vector<int>{0, 3, 3, 3}));
  EXPECT_EQ(unknowns(with_bases(four_blocks(), BlockBasis::affine)), (std::vector<int>{0, 6, 6, 6}));
  EXPECT_TRUE(has_held_moving_element(with_bases(four_blocks(), BlockBasis::rigid)));
}

TEST(ChooseBasis, old_rules_hold_blocks_by_springs_and_give_them_unknowns) {
  EXPECT_EQ(unknowns(with_moving_bases(four_blocks(), BlockBasis::rigid)), (std::vector<int>{3, 3, 3, 3}));
  EXPECT_EQ(unknowns(with_moving_bases(four_blocks(), BlockBasis::affine)), (std::vector<int>{6, 6, 6, 6}));
}

TEST(ChooseBasis, each_block_material_may_have_its_own) {
  Model model = four_blocks();
  model.elements[{1}].material = 1;
  PerMaterial<BlockBasis> basis = BlockBasis::affine;
  basis.own[1] = BlockBasis::rigid;
  EXPECT_EQ(unknowns(with_bases(model, basis)), (std::vector<int>{0, 3, 6, 6}));
}

TEST(ChooseBasis, the_plan_counts_the_unknowns_and_names_the_bases) {
  const Requirements needs = requirements(with_bases(four_blocks(), BlockBasis::rigid), Settings{});
  EXPECT_EQ(needs.unknowns, 9);
  EXPECT_FALSE(needs.has(TermKind::elastic));
  EXPECT_NE(needs.basis.find("fixed, none, for 1"), std::string::npos);
}

}  // namespace keyblock::choose_basis_test
