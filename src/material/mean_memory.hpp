// The mean of what several points of rock remember, by weight: what an element shows, and what a new mesh takes over.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "material/yield_law.hpp"

namespace keyblock {

/// Σ weight · memory. Its region is elastic where memories of more than half of the weight are, else that of most of
/// the weight of the others.
class MeanMemory {
 public:
  void add(double weight, const YieldState& memory);

  double weight() const { return weight_; }
  /// The sum over `whole`, the weight of all.
  YieldState over(double whole) const;

 private:
  YieldState sum_;
  std::array<double, static_cast<std::size_t>(YieldRegion::tension) + 1> regions_{};  // weight of each
  double weight_ = 0;
};

}  // namespace keyblock
