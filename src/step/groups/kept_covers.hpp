// Finds the elements and functions that NMM bodies share with those of an earlier scene, regardless of numbering.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "step/bodies/cover_scene.hpp"

namespace keyblock {

struct KeptCovers {
  std::vector<int> in_triangle;  ///< per element, the earlier one if it lies in the same triangle; else -1
  std::vector<int> functions;    ///< per function, the earlier one of a cover that it had in such a triangle; else -1
  std::vector<char> elements;    ///< per element: true if polygon and polynomials equal those of the earlier one
};

/// Compares two scenes. `parents`: per later element, the earlier element that it is a part of; negative if that was no
/// NMM element. Triangles are the same if their three nodes have bitwise equal positions in the same order. Polynomials
/// are compared to round-off, because derived gradients are sums over stars in the order of cover numbers.
KeptCovers kept_covers(const CoverScene& before, std::span<const int> parents, const CoverScene& after);

/// Returns the result for bodies that were no NMM bodies before.
KeptCovers nothing_kept(const CoverScene& after);

/// Returns the earlier unknowns `field` of functions that existed, 0 for the others.
Eigen::VectorXd copied(const KeptCovers& kept, const Eigen::VectorXd& field);

}  // namespace keyblock
