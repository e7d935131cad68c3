// References of the closures of an energy balance, and their response to missing terms.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/ledger.hpp"

#include <gtest/gtest.h>

#include "tests/support/ledger_sums.hpp"

namespace keyblock::result_ledger_test {
namespace {

// 100 J of gravity released: 60 kinetic, 40 lost to friction.
Ledger falling_and_rubbing() {
  Ledger ledger{{true, false, {}}, {{}, {}}};
  LedgerRow& end = ledger.rows.back();
  end.stored.kinetic = 60;
  end.stored.gravity = -100;
  end.flow.friction = 40;
  end.momentum.linear = {3, -4};
  end.impulse.linear = {3, -4};
  end.momentum_size = {5, 2};
  return ledger;
}

}  // namespace

TEST(LedgerSums, a_ledger_that_balances_closes) {
  EXPECT_EQ(support::sums_of(falling_and_rubbing()).energy_closure(), 0);
  EXPECT_EQ(support::sums_of(falling_and_rubbing()).largest_energy(), 100);
  EXPECT_EQ(support::sums_of(falling_and_rubbing()).linear_momentum_closure(), 0);
}

TEST(LedgerSums, what_is_missing_shows_relative_to_the_largest_energy_and_momentum) {
  Ledger ledger = falling_and_rubbing();
  ledger.rows.back().flow.friction = 39;
  EXPECT_DOUBLE_EQ(support::sums_of(ledger).energy_closure(), 0.01);
  ledger.rows.back().impulse.linear.x = 2.5;
  EXPECT_DOUBLE_EQ(support::sums_of(ledger).linear_momentum_closure(), 0.1);
  ledger.rows.back().momentum.angular = 1;
  EXPECT_DOUBLE_EQ(support::sums_of(ledger).angular_momentum_closure(), 0.5);
}

TEST(LedgerSums, gains_and_losses_have_opposite_signs_in_the_balance) {
  Ledger ledger = falling_and_rubbing();
  ledger.rows.back().flow.external = 7;
  ledger.rows.back().flow.impact = 7;
  EXPECT_EQ(support::sums_of(ledger).energy_closure(), 0);
}

// 100 J fall and 60 of them rise again: 160 would be created energy.
TEST(LedgerSums, energy_beyond_what_was_stored_before_and_given_is_made) {
  Ledger ledger = falling_and_rubbing();
  EXPECT_EQ(support::sums_of(ledger).energy_made(ledger.scope), 0);
  LedgerRow later = ledger.rows.back();
  later.stored.gravity = -20;  // of the 60 kinetic ones 20 came from elsewhere
  later.stored.kinetic = 0;
  ledger.rows.push_back(later);
  EXPECT_DOUBLE_EQ(support::sums_of(ledger).energy_made(ledger.scope), 0.2);
  ledger.rows.back().flow.external = 20;
  EXPECT_EQ(support::sums_of(ledger).energy_made(ledger.scope), 0);
}

TEST(LedgerSums, what_contact_springs_give_back_is_not_made) {
  Ledger ledger = falling_and_rubbing();
  LedgerRow pressed = ledger.rows.back();
  pressed.stored.kinetic = 0;
  pressed.stored.contact = 60;
  LedgerRow rebound = ledger.rows.back();
  ledger.rows.push_back(pressed);
  ledger.rows.push_back(rebound);
  EXPECT_EQ(support::sums_of(ledger).energy_made(ledger.scope), 0);
  ledger.rows.back().stored.kinetic = 90;
  EXPECT_DOUBLE_EQ(support::sums_of(ledger).energy_made(ledger.scope), 0.3);
}

// Without flows the energy of contacts is unknown: only energy above the initial one is created.
TEST(LedgerSums, without_flows_energy_counts_from_the_start) {
  Ledger ledger = falling_and_rubbing();
  ledger.scope.has_flows = false;
  ledger.rows.back().stored.kinetic = 20;
  ledger.rows.push_back(ledger.rows.back());
  ledger.rows.back().stored.kinetic = 100;
  EXPECT_EQ(support::sums_of(ledger).energy_made(ledger.scope), 0);
  ledger.rows.back().stored.kinetic = 150;
  EXPECT_DOUBLE_EQ(support::sums_of(ledger).energy_made(ledger.scope), 50.0 / 150);
}

TEST(LedgerSums, a_scene_at_rest_closes) {
  EXPECT_EQ(support::sums_of({{}, {{}, {}}}).energy_closure(), 0);
}

}  // namespace keyblock::result_ledger_test
