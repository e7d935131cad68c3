// The gradient of a field at the node of each physical cover, from the values of the covers about it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "problem/manifold.hpp"

namespace keyblock {

/// g = Σ weight · d of the covers, per length; the cover itself is one of them.
struct CoverGradient {
  struct Share {
    int cover = 0;
    Point weight;
  };
  std::vector<Share> shares;
};

/// Of the quadratic through the value of the cover that fits those of its star best, weighted by 1 / max(r², h²/4); the
/// ring beyond is taken in where there are fewer than 6 neighbours or they determine the quadratic badly (condition
/// above 50). A direction of the second order that is not determined even so (a body one row wide) is left out of the
/// fit: linear fields have their gradient always, quadratic ones where the covers can tell. Covers are neighbours where
/// they share an element, never across a joint. Relatives: FE-LSPIM (Rajendran & Zhang 2007), CN-LS (Yang, Tang &
/// Zheng).
std::vector<CoverGradient> derived_gradients(const Manifold& manifold);

}  // namespace keyblock
