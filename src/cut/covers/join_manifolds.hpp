// Bodies cut one by one from the same mesh, together.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/manifold.hpp"

namespace keyblock {

/// Adds the bodies of `more`, which was cut from the mesh of `to`, behind those of `to`. They share no covers.
void join(Manifold& to, const Manifold& more);

}  // namespace keyblock
