// Finds the triangles that two manifolds share. A mesh that is bisected elsewhere keeps most of its triangles, under
// other numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "problem/manifold.hpp"

namespace keyblock {

/// Returns, per triangle of `is`, the triangle of `was` whose nodes have the same positions to the bit, in the same
/// order; -1: none.
std::vector<int> same_triangles(const TriangleMesh& was, const TriangleMesh& is);

/// Returns true if both are without holes and have the same corners, in the same order.
bool have_same_polygon(const Manifold& was, const ManifoldElement& old, const Manifold& is,
                       const ManifoldElement& element);

}  // namespace keyblock
