// What bodies on covers have in common with those of an earlier scene, whatever their numbers were there.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "step/bodies/cover_scene.hpp"

namespace keyblock {

struct KeptCovers {
  std::vector<int> in_triangle;  ///< of each element the one before, where it lies in the same triangle; else -1
  std::vector<int> functions;  ///< of each function the one before, of a cover that it had in such a triangle; else -1
  std::vector<char> elements;  ///< whether one has the polygon of the one before, and its polynomials
};

/// `parents`: of every element after, the element before that it is a part of; below 0 where that was on no covers.
/// Triangles are the same whose three nodes have the same positions to the bit, in the same order. Polynomials are the
/// same to round-off, for those of derived gradients are sums over stars, in the order of the numbers of covers.
KeptCovers kept_covers(const CoverScene& before, std::span<const int> parents, const CoverScene& after);

/// Of bodies that were on no covers.
KeptCovers nothing_kept(const CoverScene& after);

/// The unknowns `field` before of functions that were there, 0 of the others.
Eigen::VectorXd copied(const KeptCovers& kept, const Eigen::VectorXd& field);

}  // namespace keyblock
