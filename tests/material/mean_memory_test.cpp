// Means of the memory of points of rock: strains by weight, regions by the largest weight.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/mean_memory.hpp"

#include <gtest/gtest.h>

namespace keyblock::mean_memory_test {
namespace {

YieldState memory(double plastic, YieldRegion region) {
  YieldState state;
  state.elastic(1) = 2 * plastic;
  state.plastic(0) = plastic;
  state.kappa = 3 * plastic;
  state.region = region;
  return state;
}

}  // namespace

TEST(MeanMemory, strains_are_weighed) {
  MeanMemory mean;
  mean.add(1, memory(4, YieldRegion::plane));
  mean.add(3, memory(8, YieldRegion::plane));
  const YieldState all = mean.over(mean.weight());
  EXPECT_EQ(all.plastic(0), 7);
  EXPECT_EQ(all.elastic(1), 14);
  EXPECT_EQ(all.kappa, 21);
  EXPECT_EQ(all.region, YieldRegion::plane);
}

TEST(MeanMemory, a_region_is_that_of_most_of_what_is_not_elastic) {
  MeanMemory mean;
  mean.add(5, memory(0, YieldRegion::elastic));
  EXPECT_EQ(mean.over(5).region, YieldRegion::elastic);
  mean.add(2, memory(1, YieldRegion::edge));
  mean.add(3, memory(1, YieldRegion::apex));
  EXPECT_EQ(mean.over(10).region, YieldRegion::apex);  // half is not more than half
  mean.add(1, memory(1, YieldRegion::edge));
  EXPECT_EQ(mean.over(11).region, YieldRegion::edge);  // the first of equal ones
  mean.add(8, memory(0, YieldRegion::elastic));
  EXPECT_EQ(mean.over(19).region, YieldRegion::elastic);
}

}  // namespace keyblock::mean_memory_test
