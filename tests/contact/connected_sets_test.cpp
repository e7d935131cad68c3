// Blocks in a row: a fixed one does not connect its neighbours, but holds both.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/find/connected_sets.hpp"

#include <gtest/gtest.h>

#include "tests/support/scenes.hpp"

namespace keyblock::connected_sets_test {
namespace {

Model six_blocks() {
  Blocks blocks;
  for (int i = 0; i < 6; ++i) blocks.blocks.push_back(support::rectangle({2.0 * i, 0}, {2.0 * i + 1, 1}));
  Model model = model_from_blocks(blocks, support::plain_analysis(0.01, 1));
  model.elements[ElementIndex{2}].basis = &fixed_basis();
  return model;
}

std::vector<bool> held_of(const ConnectedSets& sets) {
  std::vector<bool> held;
  for (int e = 0; e < 6; ++e) held.push_back(sets.is_held(ElementIndex{e}));
  return held;
}

}  // namespace

TEST(ConnectedSets, a_fixed_block_holds_its_neighbours_and_does_not_connect_them) {
  const ConnectedSets sets(six_blocks(), {{{1}, {0}}, {{1}, {2}}, {{2}, {3}}}, {});
  EXPECT_EQ(sets.numbers(), (std::vector<std::size_t>{0, 0, 2, 3, 4, 5}));
  EXPECT_EQ(held_of(sets), (std::vector<bool>{true, true, true, true, false, false}));
}

TEST(ConnectedSets, a_bolt_connects_and_a_support_holds_the_whole_set) {
  Model model = six_blocks();
  Bolt& bolt = model.bolts.emplace_back();
  bolt.first.element = {5};
  bolt.second.element = {3};
  const ConnectedSets sets(model, {{{4}, {3}}}, {ElementIndex{5}});
  EXPECT_EQ(sets.numbers(), (std::vector<std::size_t>{0, 1, 2, 3, 3, 3}));
  EXPECT_EQ(held_of(sets), (std::vector<bool>{false, false, true, true, true, true}));
}

}  // namespace keyblock::connected_sets_test
