// Draws uniform numbers, the same with every compiler and standard library.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace keyblock {

/// Uses the bits of the generator itself: std::mt19937_64 is fixed to the bit, the distributions of <random> are not.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : bits_(seed) {}

  double between(double low, double high) { return low + (high - low) * static_cast<double>(bits_() >> 11U) * 0x1p-53; }
  /// Returns one of 0 … count - 1.
  int below(int count) { return static_cast<int>(between(0, count)); }
  /// Draws evenly over the orders of magnitude.
  double magnitude_between(double low, double high) { return low * std::exp(between(0, std::log(high / low))); }
  bool happens(double share) { return between(0, 1) < share; }

 private:
  std::mt19937_64 bits_;
};

}  // namespace keyblock
