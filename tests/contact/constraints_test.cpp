// Rows of bolts and fixed points compared with differences of lengths and places; effect of the forces of a bolt on
// momentum.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/rows/constraints.hpp"

#include <gtest/gtest.h>

#include "contact/solve/contact_matrix.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::constraints_test {
namespace {

using support::rectangle;

constexpr double kStep = 1e-6;  // central differences: error about 1e-10
constexpr double kDifference = 1e-8;

/// Two rotated and strained blocks; a bolt from one to the other, one within the second, a point driven on the first.
struct Tied {
  Model model;
  Reference reference;
  UnknownsTable q;
  std::vector<HeldPair> held;

  Tied() {
    Blocks blocks;
    blocks.blocks = {rectangle({0, -1}, {5, 0}), rectangle({1, 0.01}, {2, 1})};
    blocks.bolts = {{{{0.5, -0.5}, {1.5, 0.75}}, 0, 1, 100, 0, 7}, {{{1.25, 0.25}, {1.75, 0.5}}, 1, 1, 100, 0, 7}};
    blocks.fixed_points = {{{4, -0.25}, 0, {}}};
    Analysis analysis = support::plain_analysis(1, 1);
    analysis.fixed_point_motions = {{{0, 2}, {{0, 0}, {0.5, -1}}, {}}};
    model = model_from_blocks(blocks, analysis);
    reference = reference_of(model, support::standard_settings(analysis));
    Unknowns a(6), b(6);
    a << 0.1, -0.05, 0.2, 0.01, -0.02, 0.03;
    b << 0.2, 0.1, 0.3, -0.02, 0.01, 0.02;
    q = {a, b};
    held = held_pairs(model);
  }
};

/// The derivative of `value` by unknown i of element e.
template <class Value>
double derivative(const Tied& tied, ElementIndex e, int i, Value value) {
  UnknownsTable forward = tied.q;
  UnknownsTable backward = tied.q;
  forward[e][i] += kStep;
  backward[e][i] -= kStep;
  return (value(forward) - value(backward)) / (2 * kStep);
}

double entry(const ContactRow& row, ElementIndex e, int i) {
  double sum = 0;
  if (row.vertex_element == e) sum += row.of_vertex[i];
  if (row.edge_element == e) sum += row.of_edge[i];
  return sum;
}

Point bolt_end(const Tied& tied, const UnknownsTable& q, const MaterialPoint& end) {
  return point_at(tied.model, tied.reference, q, end.element, end.start);
}

}  // namespace

TEST(Constraints, the_row_along_a_bolt_is_the_derivative_of_its_length) {
  const Tied tied;
  const ContactRows rows = bolt_rows(tied.model, tied.reference, tied.q);
  ASSERT_EQ(rows.size(), 4U);
  for (const Eigen::Index bolt : {0, 1}) {
    const auto length = [&](const UnknownsTable& q) { return elongations(tied.model, tied.reference, q)[bolt]; };
    for (ElementIndex e : indices(tied.q))
      for (int i = 0; i < 6; ++i)
        EXPECT_NEAR(entry(rows[2 * static_cast<std::size_t>(bolt)], e, i), derivative(tied, e, i, length), kDifference);
  }
}

TEST(Constraints, the_row_across_a_bolt_is_its_turning_times_its_length) {
  const Tied tied;
  const ContactRows rows = bolt_rows(tied.model, tied.reference, tied.q);
  const auto chord = [&](const UnknownsTable& q) {
    return bolt_end(tied, q, tied.model.bolts[0].second) - bolt_end(tied, q, tied.model.bolts[0].first);
  };
  const auto angle = [&](const UnknownsTable& q) { return std::atan2(chord(q).y, chord(q).x); };
  for (ElementIndex e : indices(tied.q))
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(entry(rows[1], e, i), derivative(tied, e, i, angle) * length(chord(tied.q)), kDifference);
}

// Rotating and shifting a bolt as a whole keeps its length: 3-4-5 triangle, closed form.
TEST(Constraints, elongation_is_present_length_less_that_at_the_start) {
  Tied tied;
  tied.model.bolts = {{{{0, 0}, {0}}, {{3, 4}, {1}}, 1, 0, 0}};
  tied.q = {Unknowns::Zero(6), Unknowns::Zero(6)};
  EXPECT_EQ(elongations(tied.model, tied.reference, tied.q)[0], 0);
  tied.q[ElementIndex{1}].head<2>() << 2, 8;  // to (5, 12)
  EXPECT_NEAR(elongations(tied.model, tied.reference, tied.q)[0], 13 - 5, 1e-14);
}

TEST(Constraints, the_force_of_a_bolt_keeps_both_momenta) {
  const Tied tied;
  const ContactRows rows = bolt_rows(tied.model, tied.reference, tied.q);
  UnknownsTable rate = tied.q;
  for (ElementIndex e : indices(rate)) {
    const Point c = tied.reference.centroids[e] + translation(*tied.model.elements[e].basis, tied.q[e]);
    rate[e] << 0.3 - 2 * c.y, -0.7 + 2 * c.x, 2, 0, 0, 0;  // rotating by 2 rad/s about the origin, and a shift
  }
  const Eigen::VectorXd seen = rates(rows, rate);
  EXPECT_NEAR(seen[0], 0, 1e-13);  // no power in a rigid motion of all: no net force and no net moment
  EXPECT_NEAR(seen[2], 0, 1e-13);
}

TEST(Constraints, contact_matrix_of_a_bolt_within_one_block_is_that_of_its_definition) {
  const Tied tied;
  const ContactRows rows = bolt_rows(tied.model, tied.reference, tied.q);
  Table<ElementIndex, UnknownBlock> blocks;
  for (int e = 0; e < 2; ++e) blocks.push_back((e + 1.0) * UnknownBlock::Identity(6, 6));
  const ContactMatrix w(rows, {blocks});
  for (Eigen::Index i = 0; i < w.rows(); ++i) {
    const Eigen::VectorXd column = rates(rows, answer(rows, {blocks}, Eigen::VectorXd::Unit(w.rows(), i)));
    EXPECT_NEAR(w.diagonal()[i], column[i], 1e-13);
    for (Eigen::Index j = 0; j < w.rows(); ++j) EXPECT_NEAR(RowThrough(w, i).times(j), column[j], 1e-13);
  }
}

TEST(Constraints, the_rows_of_a_held_point_are_the_derivatives_of_its_place) {
  const Tied tied;
  const ContactRows rows = point_rows(tied.model, tied.reference, tied.q, tied.held);
  ASSERT_EQ(rows.size(), 2U);
  for (const Eigen::Index axis : {0, 1}) {
    const auto place = [&](const UnknownsTable& q) {
      return offsets(tied.model, tied.reference, q, tied.held, 0)[axis];
    };
    for (ElementIndex e : indices(tied.q))
      for (int i = 0; i < 6; ++i)
        EXPECT_NEAR(entry(rows[static_cast<std::size_t>(axis)], e, i), derivative(tied, e, i, place), kDifference);
  }
}

TEST(Constraints, a_driven_point_is_off_by_what_its_motion_lacks) {
  Tied tied;
  tied.q[ElementIndex{0}] = Unknowns::Zero(6);
  tied.q[ElementIndex{0}].head<2>() << 0.125, 0;
  // The motion at t = 1 is (0.25, -0.5), half of its last row.
  EXPECT_LE((offsets(tied.model, tied.reference, tied.q, tied.held, 1) - Eigen::Vector2d(-0.125, 0.5)).norm(), 1e-14);
  EXPECT_LE((wanted_velocities(tied.held, 1.5, 0.25) - Eigen::Vector2d(0.25, -0.5)).norm(), 1e-14);
  EXPECT_EQ(wanted_velocities(tied.held, 2, 0.25).norm(), 0);  // past its table a motion stays as it was
}

TEST(Constraints, points_of_fixed_elements_hold_nothing) {
  Tied tied;
  tied.model.elements[ElementIndex{0}].basis = &fixed_basis();
  EXPECT_TRUE(held_pairs(tied.model).empty());
  tied.q[ElementIndex{0}] = Unknowns::Zero(0);
  EXPECT_EQ(bolt_rows(tied.model, tied.reference, tied.q)[0].of_edge.size(), 0);
}

}  // namespace keyblock::constraints_test
