// Computes physical covers: the connected parts of the stars of mathematical nodes.
// Theory: docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/manifold.hpp"

namespace keyblock {

/// Computes the covers of the elements, whose neighbours must be set.
void set_covers(Manifold& manifold);

/// Renumbers the covers after elements were given those of others; covers without elements are left out.
void relist_covers(Manifold& manifold);

}  // namespace keyblock
