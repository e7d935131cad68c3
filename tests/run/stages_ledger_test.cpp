// The energy balance closes through every change of a scene: excavations under contact, a tunnel, random changes in
// flight.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>

#include "formats/case.hpp"
#include "problem/checks/check.hpp"
#include "tests/support/ledger_sums.hpp"
#include "tests/support/random_changes.hpp"
#include "tests/support/staged_runs.hpp"

namespace keyblock::stages_ledger_test {
namespace {

using support::ChangesTold;
using support::ChangingBodies;
using support::random_changes;
using support::Told;
using support::told_of;
using support::told_of_changes;
using support::wall_with_opening;

}  // namespace

class StagesUnderContact : public testing::TestWithParam<const char*> {};

TEST_P(StagesUnderContact, close_the_ledger_of_an_excavation_in_four_stages) {
  const Told told = told_of(wall_with_opening(), {{"enforcement", GetParam()}});
  EXPECT_EQ(told.outcome.scenes.size(), 4U);
  EXPECT_EQ(told.outcome.steps, 120);
  const LedgerSums sums = support::sums_of(told.ledger);
  EXPECT_LT(sums.energy_closure(), 1e-10);
  EXPECT_NE(told.ledger.rows.back().flow.change, 0);
}

INSTANTIATE_TEST_SUITE_P(Enforcements, StagesUnderContact, testing::Values("lagrange", "penalty", "augmented"),
                         [](const auto& one) { return std::string(one.param); });

// Notched blocks of a tunnel: a corner at which two convex pieces of a block meet is one contact with one memory.
// Counted as two, it made the energy wrong by a tenth.
TEST(StagesLedger, closes_for_the_tunnel) {
  const std::string file = std::string(KEYBLOCK_SOURCE_DIR) + "/docs/tunnel.json";
  const Problem problem = check(formats::load_case({file}).problem).problem;
  const Told told = told_of(problem, {{"basis", "rigid"}, {"start", "sudden"}});
  EXPECT_EQ(told.outcome.scenes.size(), 4U);
  EXPECT_LT(support::sums_of(told.ledger).energy_closure(), 1e-10);
}

// Angular momentum closes to 5e-6 here without any change too: impacts of blocks that deform. A thousand changes in
// `make validate`.
TEST(StagesLedger, closes_through_random_changes_in_flight) {
  const ChangesTold told = told_of_changes(random_changes(ChangingBodies::blocks, 12, 200, 20, {}));
  EXPECT_EQ(told.why, "");
  EXPECT_EQ(told.scenes, 201U);
  EXPECT_LT(told.momentum, 1e-12);
  EXPECT_LT(told.at_change, 1e-12);
  EXPECT_LT(told.energy, 1e-7);
}

/// Repeated cuts and excavations soon leave only dust: a hundred changes of each. With 10 seeds in `make validate`.
struct ChangesOnCovers {
  ChangingBodies bodies;
  CoverFunctions functions;
};
class RandomChanges : public testing::TestWithParam<ChangesOnCovers> {};

TEST_P(RandomChanges, on_covers_keep_momentum_and_energy) {
  const auto [bodies, functions] = GetParam();
  // Covers with gradients of their own lose their mass in round-off sooner or later, as blocks are cut ever smaller;
  // such scenes are refused.
  const int changes = functions == CoverFunctions::linear ? 10 : 100;
  const ChangesTold told = told_of_changes(random_changes(bodies, 5, changes, 1, functions));
  EXPECT_EQ(told.why, "");
  EXPECT_EQ(told.scenes, changes + 1U);
  EXPECT_LT(told.at_change, 1e-12);
  EXPECT_LT(told.energy, 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Meshes, RandomChanges,
                         testing::Values(ChangesOnCovers{ChangingBodies::meshes, CoverFunctions::constant},
                                         ChangesOnCovers{ChangingBodies::meshes, CoverFunctions::derived},
                                         ChangesOnCovers{ChangingBodies::meshes, CoverFunctions::linear},
                                         ChangesOnCovers{ChangingBodies::one_mesh, CoverFunctions::constant},
                                         ChangesOnCovers{ChangingBodies::one_mesh, CoverFunctions::derived}),
                         [](const auto& one) {
                           return (one.param.bodies == ChangingBodies::meshes ? "meshes_" : "one_mesh_") +
                                  std::string(name_of(one.param.functions));
                         });

}  // namespace keyblock::stages_ledger_test
