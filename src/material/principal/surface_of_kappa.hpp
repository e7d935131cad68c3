// Defines a yield surface that changes with the plastic strain.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/yield.hpp"

namespace keyblock {

/// Strength that changes linearly in κ from 0 to `strain`.
struct SurfaceOfKappa {
  const Strength& strength;
  double strain;  ///< at the end of the change; infinity: no change
};

}  // namespace keyblock
