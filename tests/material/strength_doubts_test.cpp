// Warnings about strengths that can be used but are hardly intended.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/sentences/sentences.hpp"
#include "material/strength.hpp"

namespace keyblock::strength_doubts_test {
namespace {

Strength of(YieldSurface surface, const StrengthValues& values, ConeMatching matching = ConeMatching::compression) {
  return {surface, matching, values, {}};
}

std::string only_doubt(const Strength& strength) {
  const std::vector<Finding> doubts = doubts_of(strength);
  return doubts.size() == 1 ? doubts.front().code() + ": " + sentence_of(doubts.front())
                            : std::to_string(doubts.size()) + " doubts";
}

}  // namespace

// 20 cot 30° = 34.64: the planes of Mohr and Coulomb meet there, and so do all cones matched to them.
TEST(StrengthDoubts, tensile_strength_beyond_the_apex_has_no_effect) {
  const double apex = 20 * std::sqrt(3.0);
  for (const YieldSurface surface : {YieldSurface::mohr_coulomb, YieldSurface::drucker_prager}) {
    StrengthValues values{.cohesion = 20, .friction_deg = 30, .dilation_deg = 30, .tensile_strength = 0.99 * apex};
    EXPECT_EQ(doubts_of(of(surface, values)).size(), 0U);
    values.tensile_strength = 1.01 * apex;
    EXPECT_NE(only_doubt(of(surface, values)).find("above the apex of the surface, c cot φ = 34.64"),
              std::string::npos);
  }
  const StrengthValues no_friction{.cohesion = 20, .tensile_strength = 1e6};
  EXPECT_EQ(doubts_of(of(YieldSurface::tresca, no_friction)).size(), 0U);
}

TEST(StrengthDoubts, a_softened_strength_is_looked_at_where_its_tensile_strength_changes) {
  Strength strength = of(YieldSurface::mohr_coulomb, {.cohesion = 20, .friction_deg = 30, .tensile_strength = 10});
  StrengthChange change;
  change.fracture_energy = 1;
  change.values = {.cohesion = 2, .friction_deg = 30, .tensile_strength = 10};
  strength.change = change;
  EXPECT_EQ(doubts_of(strength).size(), 0U);
  strength.change->values.tensile_strength = 5;
  EXPECT_NE(only_doubt(strength).find("3.464 after the change"), std::string::npos);
}

TEST(StrengthDoubts, matchings_that_are_not_read_or_not_that_of_the_flow_are_told) {
  const StrengthValues associated{.cohesion = 20, .friction_deg = 30, .dilation_deg = 30};
  const StrengthValues other{.cohesion = 20, .friction_deg = 30, .dilation_deg = 10};
  const auto cone = [&](const StrengthValues& values) {
    return of(YieldSurface::drucker_prager, values, ConeMatching::plane_strain);
  };
  EXPECT_EQ(doubts_of(cone(associated)).size(), 0U);
  EXPECT_NE(only_doubt(cone(other)).find("dilation_deg 10 and friction_deg 30"), std::string::npos);
  EXPECT_EQ(doubts_of(of(YieldSurface::drucker_prager, other, ConeMatching::extension)).size(), 0U);
  EXPECT_NE(only_doubt(of(YieldSurface::mohr_coulomb, associated, ConeMatching::extension)).find("no effect"),
            std::string::npos);
}

}  // namespace keyblock::strength_doubts_test
