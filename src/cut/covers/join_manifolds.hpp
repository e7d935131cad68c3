// Joins bodies cut one by one from the same mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/manifold.hpp"

namespace keyblock {

/// Appends the bodies of `more` to those of `to`. Both must be cut from the same mesh; they share no covers.
void join(Manifold& to, const Manifold& more);

}  // namespace keyblock
