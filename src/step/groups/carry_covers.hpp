// Displacement and velocity of bodies on covers, carried over to what is left of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "geometry/box.hpp"
#include "step/bodies/cover_scene.hpp"
#include "step/groups/body_group.hpp"

namespace keyblock {

struct CarriedCovers {
  Eigen::VectorXd d;
  Eigen::VectorXd v;
  YieldStates points = {};  ///< of rock that may yield, where they are carried by points
};

/// The fields of the bodies before, projected by mass onto the functions of the bodies after: M d = ∫ ρ Tᵀ u. The
/// projection leaves a field that the functions hold as it is, and of any field it keeps the momentum, for a uniform
/// field is among them; the angular momentum of every body, about which the projection of the displacement says
/// nothing, is kept by a turning of the body. `parents`: of every element after, the element before that it is a part
/// of, in the same triangle of the same mesh.
CarriedCovers carried_covers(const CoverScene& before, const Eigen::VectorXd& d, const Eigen::VectorXd& v,
                             std::span<const int> parents, const CoverScene& after);

/// The same from points of the fields before over each element after: of other meshes, and of blocks that are given
/// covers. Momentum and angular momentum of each body are those of its points; displacements are nearest in the energy
/// of elastic rock.
CarriedCovers carried_covers(std::span<const std::vector<FieldPoint>> fields, const CoverScene& after);

/// An element of a body with the box about it.
struct BoxedElement {
  Box box;
  int element = 0;
};

/// Of every body.
std::vector<std::vector<BoxedElement>> boxed_elements(const CoverScene& bodies);

/// The fields of a body, which has these elements, over a region of the start: exact to the product of the fields with
/// each other, and with a polynomial of `degree`.
std::vector<FieldPoint> field_over(const CoverScene& bodies, std::span<const BoxedElement> elements,
                                   std::span<const std::vector<Point>> region, int degree, const Eigen::VectorXd& d,
                                   const Eigen::VectorXd& v);

bool is_same_mesh(const Manifold& a, const Manifold& b);

}  // namespace keyblock
