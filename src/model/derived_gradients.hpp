// Derives the gradient of a field at the node of each physical cover from the values of the covers around it.
// Theory: docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "problem/manifold.hpp"

namespace keyblock {

/// g = Σ weight · d over covers, per length; the cover itself is one of them.
struct CoverGradient {
  struct Share {
    int cover = 0;
    Point weight;
  };
  std::vector<Share> shares;
};

/// Returns the gradient of the quadratic through the value of each cover that fits its star best.
///
/// Weights are 1 / max(r², h²/4). The ring beyond is included if there are fewer than 6 neighbours or if they determine
/// the quadratic badly (condition above 50). A second-order direction that is still not determined (a body one row
/// wide) is left out of the fit. Linear fields always get their exact gradient, quadratic ones if the covers determine
/// it. Covers are neighbours if they share an element, never across a joint. Related: FE-LSPIM (Rajendran & Zhang
/// 2007), CN-LS (Yang, Tang & Zheng).
std::vector<CoverGradient> derived_gradients(const Manifold& manifold);

}  // namespace keyblock
