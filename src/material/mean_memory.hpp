// Averages the memories of several points of rock by weight, for the values of an element and the transfer to a new
// mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "material/yield_law.hpp"

namespace keyblock {

/// Σ weight · memory. The region is elastic if elastic memories have more than half of the weight. Otherwise it is the
/// region with most of the weight among the others.
class MeanMemory {
 public:
  void add(double weight, const YieldState& memory);

  double weight() const { return weight_; }
  /// Returns the sum over `whole`, the weight of all.
  YieldState over(double whole) const;

 private:
  YieldState sum_;
  std::array<double, static_cast<std::size_t>(YieldRegion::tension) + 1> regions_{};  // weight per region
  double weight_ = 0;
};

}  // namespace keyblock
