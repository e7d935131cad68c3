// Sums strains, and the weights of regions; see mean_memory.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/mean_memory.hpp"

namespace keyblock {
namespace {

constexpr double kRoundingOfWeight = 1e-9;  // per total weight

}  // namespace

void MeanMemory::add(double weight, const YieldState& memory) {
  sum_.elastic += weight * memory.elastic;
  sum_.plastic += weight * memory.plastic;
  sum_.kappa += weight * memory.kappa;
  regions_[static_cast<std::size_t>(memory.region)] += weight;
  weight_ += weight;
}

// Regions whose weights differ by rounding alone count as equal, and the first of them is taken.
YieldState MeanMemory::over(double whole) const {
  YieldState mean = sum_;
  mean.elastic /= whole;
  mean.plastic /= whole;
  mean.kappa /= whole;
  if (regions_.front() > (0.5 + kRoundingOfWeight) * whole) return mean;
  std::size_t most = 0;
  for (std::size_t i = 1; i < regions_.size(); ++i)
    if (regions_[i] > (most == 0 ? 0 : regions_[most]) + kRoundingOfWeight * whole) most = i;
  mean.region = static_cast<YieldRegion>(most);
  return mean;
}

}  // namespace keyblock
