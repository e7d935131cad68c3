// Rows of gap and slip against differences of the gap itself; momentum of a pair of contact forces.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/rows/gap.hpp"

#include <gtest/gtest.h>

#include "contact/solve/contact_matrix.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::gap_test {
namespace {

using support::rectangle;

struct Pair {
  Model model;
  Reference reference;
  UnknownsTable q;

  Pair() {
    Blocks blocks;
    blocks.blocks = {rectangle({0, -1}, {5, 0}), rectangle({1, 0.01}, {2, 1})};
    const Analysis analysis = support::plain_analysis(1, 1);
    model = model_from_blocks(blocks, analysis);
    reference = reference_of(model, support::standard_settings(analysis));
    Unknowns a(6), b(6);
    a << 0.1, -0.05, 0.2, 0.01, -0.02, 0.03;
    b << 0.2, 0.1, 0.3, -0.02, 0.01, 0.02;
    q = {a, b};
  }
  double gap(const UnknownsTable& at) const { return gap_of(kTouch, vertices_at(model, reference, at)); }

  static constexpr Touch kTouch{{4}, {2}, {3}};
};

}  // namespace

TEST(Gap, its_row_is_its_derivative_with_the_turning_of_the_normal) {
  const Pair pair;
  const ContactRows rows = contact_rows(pair.model, pair.reference, pair.q, {Pair::kTouch});
  constexpr double kStep = 1e-6;  // central differences: error about 1e-10
  for (ElementIndex e : indices(pair.q)) {
    for (int i = 0; i < 6; ++i) {
      UnknownsTable forward = pair.q;
      UnknownsTable backward = pair.q;
      forward[e][i] += kStep;
      backward[e][i] -= kStep;
      const double derivative = (pair.gap(forward) - pair.gap(backward)) / (2 * kStep);
      const double row = e == rows[0].vertex_element ? rows[0].of_vertex[i] : rows[0].of_edge[i];
      EXPECT_NEAR(row, derivative, 1e-8) << "element " << e.value << ", unknown " << i;
    }
  }
}

// A rigid motion of both blocks together changes neither gap nor slip, with the gap open: forces keep both momenta.
TEST(Gap, a_common_rigid_motion_is_seen_by_no_row) {
  const Pair pair;
  const ContactRows rows = contact_rows(pair.model, pair.reference, pair.q, {Pair::kTouch});
  UnknownsTable rate = pair.q;
  for (ElementIndex e : indices(rate)) {
    const Point c = pair.reference.centroids[e] + translation(*pair.model.elements[e].basis, pair.q[e]);
    rate[e] << 0.3 - 2 * c.y, -0.7 + 2 * c.x, 2, 0, 0, 0;  // rotating by 2 rad/s about the origin, and a shift
  }
  EXPECT_LE(rates(rows, rate).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(Gap, contact_matrix_is_that_of_its_definition) {
  const Pair pair;
  const ContactRows rows = contact_rows(pair.model, pair.reference, pair.q, {Pair::kTouch, {{5}, {2}, {3}}});
  Table<ElementIndex, UnknownBlock> blocks;
  for (int e = 0; e < 2; ++e) blocks.push_back((e + 1.0) * UnknownBlock::Identity(6, 6));
  const ContactMatrix w(rows, {blocks});
  for (Eigen::Index i = 0; i < w.rows(); ++i) {
    const Eigen::VectorXd column = rates(rows, answer(rows, {blocks}, Eigen::VectorXd::Unit(w.rows(), i)));
    EXPECT_NEAR(w.diagonal()[i], column[i], 1e-14);
    for (Eigen::Index j = 0; j < w.rows(); ++j) EXPECT_NEAR(RowThrough(w, i).times(j), column[j], 1e-14);
  }
}

}  // namespace keyblock::gap_test
