// Prescribed displacements that contradict each other are refused with both named; those that agree, or concern
// different components or bodies, are not.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/bodies/agreement.hpp"

#include <gtest/gtest.h>

#include <string>

#include "run/prepare.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::agreement_test {
namespace {

DisplacementPlan held(std::vector<Point> along, Held component, const char* x, const char* y,
                      const char* normal = "0") {
  return {std::move(along), component, {x, {}}, {y, {}}, {normal, {}}, {}};
}

/// A plate of 5 by 2, or the one beside another.
Problem plate(std::vector<DisplacementPlan> displacements, bool has_second_body = false) {
  Problem problem;
  Blocks blocks;
  blocks.blocks = {support::rectangle({0, 0}, {5, 2})};
  if (has_second_body) blocks.blocks.push_back(support::rectangle({5, 0}, {8, 2}));
  problem.geometry = blocks;
  problem.analysis = support::plain_analysis(1, 1);
  problem.analysis->velocity_carry_over = 0;
  CoverPlan plan;
  plan.contact = CoverContact::ignored;
  plan.mesh.side = 0.7;
  plan.mesh.angle_deg = 10;
  plan.displacements = std::move(displacements);
  for (std::size_t i = 0; i < plan.displacements.size(); ++i)
    plan.displacements[i].place = {"case.json", static_cast<int>(i) + 1, 1};
  problem.covers = plan;
  return problem;
}

/// Returns the error; empty if they agree.
std::string fault_of(std::vector<DisplacementPlan> displacements, bool has_second_body = false) {
  try {
    prepare(plate(std::move(displacements), has_second_body), "standard", {});
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

bool are_refused(std::vector<DisplacementPlan> displacements, bool has_second_body = false) {
  return fault_of(std::move(displacements), has_second_body).find("that agree at common points") != std::string::npos;
}

}  // namespace

TEST(Agreement, edges_that_meet_in_a_point_of_an_edge_with_different_values_are_refused_with_both_places) {
  const std::string fault =
      fault_of({held({{1, 0}, {5, 0}}, Held::both, "0", "0"), held({{5, 0}, {5, 2}}, Held::x, "0", "0"),
                held({{0, 0}, {1, 0}}, Held::both, "0", "-2e-05")});
  EXPECT_EQ(fault.find("case.json:3:1: error: expected prescribed displacements that agree at common points, found "
                       "(0, -2e-05) here and (0, 0) in that of case.json:1:1 at the point (1, 0)"),
            0U)
      << fault;
}

TEST(Agreement, edges_that_meet_in_a_corner_or_lie_over_one_another_are_looked_at_too) {
  EXPECT_TRUE(
      are_refused({held({{0, 0}, {5, 0}}, Held::both, "0", "0"), held({{5, 0}, {5, 2}}, Held::x, "1e-9", "0")}));
  EXPECT_TRUE(are_refused({held({{0, 0}, {3, 0}}, Held::y, "0", "0"), held({{4, 0}, {2, 0}}, Held::y, "0", "1")}));
  EXPECT_TRUE(are_refused({held({{0, 0}, {3, 0}}, Held::y, "0", "x"), held({{4, 0}, {2, 0}}, Held::y, "0", "6 - x")}))
      << "equal in one point of the stretch that both hold";
  EXPECT_TRUE(
      are_refused({held({{0, 0}, {3, 0}}, Held::normal, "0", "0", "0.1"), held({{3, 0}, {5, 0}}, Held::y, "0", "0")}));
}

TEST(Agreement, equal_values_agree) {
  EXPECT_EQ(fault_of({held({{0, 0}, {3, 0}}, Held::both, "0", "0.1"), held({{3, 0}, {5, 0}}, Held::both, "0", "0.1")}),
            "");
  EXPECT_EQ(
      fault_of({held({{0, 0}, {5, 0}}, Held::both, "0", "0.1 * x / 5"), held({{5, 0}, {5, 2}}, Held::y, "0", "0.1")}),
      "");
  EXPECT_EQ(fault_of({held({{0, 0}, {3, 0}}, Held::y, "0", "x"), held({{4, 0}, {3, 0}}, Held::y, "0", "6 - x")}), "");
  EXPECT_EQ(
      fault_of({held({{0, 0}, {3, 0}}, Held::normal, "0", "0", "0.1"), held({{3, 0}, {5, 0}}, Held::y, "0", "-0.1")}),
      "");
}

TEST(Agreement, different_components_never_contradict) {
  EXPECT_EQ(fault_of({held({{0, 0}, {5, 0}}, Held::y, "0", "1"), held({{0, 0}, {5, 0}}, Held::x, "2", "0"),
                      held({{5, 0}, {5, 2}}, Held::normal, "0", "0", "2")}),
            "");
}

TEST(Agreement, edges_that_do_not_meet_and_bodies_side_by_side_do_not_contradict) {
  EXPECT_EQ(fault_of({held({{0, 0}, {2, 0}}, Held::both, "0", "0"), held({{2.001, 0}, {5, 0}}, Held::both, "0", "1")}),
            "");
  EXPECT_EQ(
      fault_of({held({{0, 0}, {5, 0}}, Held::both, "0", "0"), held({{5, 0}, {8, 0}}, Held::both, "0", "1")}, true), "");
}

TEST(Agreement, one_formula_in_two_chains_is_one_condition) {
  EXPECT_EQ(fault_of({held({{0, 0}, {5, 0}}, Held::both, "0", "0", "0.1"),
                      held({{5, 0}, {5, 2}}, Held::both, "0", "0", "0.1")}),
            "");
}

// A fixed point stays; an edge that is driven through it contradicts it, and one that is fixed does not.
TEST(Agreement, a_fixed_point_on_a_driven_edge_is_refused) {
  const auto fault = [](Point fixed, DisplacementPlan displacement) {
    Problem problem = plate({std::move(displacement)});
    problem.covers->contact = CoverContact::felt;
    std::get<Blocks>(problem.geometry).fixed_points = {{fixed, 0, {}}};
    try {
      prepare(problem, "standard", {{"motion", "static"}});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto edge = [](const char* x) { return held({{0, 2}, {0, 0}}, Held::x, x, "0"); };
  for (const Point fixed : {Point{0, 0}, Point{0, 0.7}, Point{0, 2}})
    EXPECT_NE(fault(fixed, edge("-1e-3")).find("case.json:1:1: error: expected a prescribed displacement of 0 at"),
              std::string::npos)
        << fixed.y << fault(fixed, edge("-1e-3"));
  EXPECT_EQ(fault({5, 1}, edge("-1e-3")), "");
  EXPECT_EQ(fault({0, 1}, edge("0")), "");
  EXPECT_EQ(fault({0, 1}, edge("1e-3*(y-1)")), "") << "a rotation about it";
}

}  // namespace keyblock::agreement_test
