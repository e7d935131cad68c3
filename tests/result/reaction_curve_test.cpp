// Reactions of driven edges: definition of driven, slope, and the plateau of a reaction.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/reaction_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock::reaction_curve_test {
namespace {

/// Displacement 1 is fixed, 2 is driven by 0, 1, 2, … and pushes back down.
History history_of(const std::vector<double>& reactions) {
  History history;
  for (std::size_t i = 0; i < reactions.size(); ++i) {
    HistoryRow row;
    row.step = static_cast<int>(i);
    row.reactions = {{0, reactions[i]}, {0.1, -reactions[i]}};
    row.driven = {0, static_cast<double>(i)};
    history.rows.push_back(row);
  }
  return history;
}

}  // namespace

TEST(ReactionCurve, an_elastic_edge_has_the_slope_1_and_no_plateau) {
  const std::vector<ReactionCurve> curves = reaction_curves(history_of({0, 2, 4, 6, 8}));
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves[0].number, 1U);
  EXPECT_EQ(curves[0].component, 'y');
  EXPECT_EQ(curves[0].reaction, (std::vector<double>{0, -2, -4, -6, -8}));
  EXPECT_DOUBLE_EQ(end_slope(curves[0]).value(), 1);
  EXPECT_FALSE(plateau_of(curves[0]));
}

TEST(ReactionCurve, a_plateau_is_of_three_steps_at_least) {
  EXPECT_FALSE(plateau_of(reaction_curves(history_of({0, 2, 3, 3.0001, 3.0002}))[0]));
  const ReactionCurve curve = reaction_curves(history_of({0, 2, 3, 3.0001, 3.0002, 3.0002}))[0];
  EXPECT_EQ(curve.steps[plateau_of(curve).value()], 2);
  EXPECT_DOUBLE_EQ(end_slope(curve).value(), 0);
  EXPECT_FALSE(plateau_of(reaction_curves(history_of({0, 2, 3, 3.0001, 3.0002, 3.0002, 3.1}))[0]));
}

// If the edge moves by 1 in 300 the reaction grows by 0.004 / 3 / (1/300) = 0.4 of it: no plateau, however small the
// steps are.
TEST(ReactionCurve, small_steps_alone_make_no_plateau) {
  History history = history_of({3, 3.004, 3.008, 3.012, 3.016});
  for (std::size_t i = 0; i < history.rows.size(); ++i) history.rows[i].driven[1] = 300 + static_cast<double>(i);
  EXPECT_FALSE(plateau_of(reaction_curves(history)[0]));
  // The same growth while the displacement grows threefold is 0.0013 / (2/3) = 0.002 of it.
  for (std::size_t i = 0; i < history.rows.size(); ++i) history.rows[i].driven[1] = std::pow(3, i);
  EXPECT_TRUE(plateau_of(reaction_curves(history)[0]));
}

// Each step of 1 in 10,000 adds 1e-4 of the reaction: it grows as fast as the displacement does.
TEST(ReactionCurve, many_small_steps_make_no_plateau_of_a_reaction_that_grows) {
  std::vector<double> reactions;
  for (int i = 0; i < 2000; ++i) reactions.push_back(10 + 1e-3 * i);
  History history = history_of(reactions);
  for (std::size_t i = 0; i < history.rows.size(); ++i) history.rows[i].driven[1] = 10000 + static_cast<double>(i);
  EXPECT_FALSE(plateau_of(reaction_curves(history)[0]));
}

// A constant reaction while the edge moves by one more hundredth may be a kink of its curve.
TEST(ReactionCurve, a_plateau_leads_a_tenth_further_at_least) {
  History history = history_of({0, 2, 3, 3, 3, 3, 3});
  for (std::size_t i = 2; i < history.rows.size(); ++i) history.rows[i].driven[1] = 2 + 0.02 * static_cast<double>(i);
  EXPECT_FALSE(plateau_of(reaction_curves(history)[0]));
  history.rows.back().driven[1] = 2.3;
  EXPECT_TRUE(plateau_of(reaction_curves(history)[0]));
}

TEST(ReactionCurve, an_edge_that_is_held_at_the_end_has_no_plateau) {
  History history = history_of({0, 2, 3, 3, 3, 3});
  EXPECT_TRUE(plateau_of(reaction_curves(history)[0]));
  history.rows.push_back(history.rows.back());
  EXPECT_FALSE(plateau_of(reaction_curves(history)[0]));
  EXPECT_FALSE(end_slope(reaction_curves(history)[0]));
}

TEST(ReactionCurve, nothing_is_driven_where_steps_do_not_follow_it) {
  History history = history_of({0, 1, 2});
  for (HistoryRow& row : history.rows) row.driven.clear();
  EXPECT_TRUE(reaction_curves(history).empty());
  EXPECT_TRUE(reaction_curves({}).empty());
}

}  // namespace keyblock::reaction_curve_test
