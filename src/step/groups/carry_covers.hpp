// Displacement and velocity of bodies on covers, carried over to what is left of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>

#include "step/bodies/cover_scene.hpp"

namespace keyblock {

struct CarriedCovers {
  Eigen::VectorXd d;
  Eigen::VectorXd v;
};

/// The fields of the bodies before, projected by mass onto the functions of the bodies after: M d = ∫ ρ Tᵀ u. The
/// projection leaves a field that the functions hold as it is, and of any field it keeps the momentum, for a uniform
/// field is among them; the angular momentum of every body, about which the projection of the displacement says
/// nothing, is kept by a turning of the body. `parents`: of every element after, the element before that it is a part
/// of, in the same triangle of the same mesh.
CarriedCovers carried_covers(const CoverScene& before, const Eigen::VectorXd& d, const Eigen::VectorXd& v,
                             std::span<const int> parents, const CoverScene& after);

}  // namespace keyblock
