// Elastic blocks on springs in a row, as springs in series.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/rows/joined_blocks.hpp"

#include <gtest/gtest.h>

namespace keyblock::joined_blocks_test {

// Unknowns of a block: place of its middle and elongation; stiffness of its length. The first is tied to the plane, a
// load pulls at the end of the last. A force f makes a block longer by f / kLength.
TEST(JoinedBlocks, a_chain_gives_way_as_its_springs_in_series) {
  constexpr int kBlocks = 5;
  constexpr double kLength = 300, kJoint = 1e5, kLoad = 7;
  Table<ElementIndex, UnknownBlock> stiffness;
  UnknownsTable loads;
  for (int i = 0; i < kBlocks; ++i) {
    stiffness.push_back(UnknownBlock(Eigen::Matrix2d(Eigen::Vector2d(1e-12, kLength).asDiagonal())));
    loads.push_back(Unknowns::Zero(2));
  }
  loads[ElementIndex{kBlocks - 1}] << kLoad, kLoad / 2;
  const Eigen::RowVector2d left(1, -0.5), right(-1, -0.5), none(0, 0);
  ContactRows rows;
  for (int i = 0; i < kBlocks; ++i) {
    rows.push_back({{i}, {i == 0 ? 0 : i - 1}, left, i == 0 ? none : right});
    rows.push_back({{i}, {i == 0 ? 0 : i - 1}, none, none});
  }
  const Eigen::VectorXd compliance = Eigen::VectorXd::Constant(2 * kBlocks, 1 / kJoint);
  Eigen::VectorXd gaps = Eigen::VectorXd::Zero(2 * kBlocks);
  gaps[0] = 0.1;
  const auto made = displacements_of_joined(stiffness, rows, compliance, gaps, loads);
  ASSERT_TRUE(made);
  const Unknowns& last = (*made)[ElementIndex{kBlocks - 1}];
  const double end = last[0] + last[1] / 2;
  EXPECT_NEAR(end, -gaps[0] + kLoad * (kBlocks / kJoint + kBlocks / kLength), 1e-9);
}

}  // namespace keyblock::joined_blocks_test
