// The two faces of cracks that lie on each other: where they touch, and how they press and rub in a linear static
// solution.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "contact/rows/contact_row.hpp"
#include "model/continuum.hpp"
#include "system/cholmod/sparse_factor.hpp"

namespace keyblock {

/// A point inside a piece of both faces of a crack, which lie on each other before any load.
struct FacePoint {
  int element = 0;  ///< of the manifold
  int other = 0;    ///< element across the crack
  int edge = 0;     ///< of the other element, by the corner at which it ends, counted through its loops from 0
  Point at;         ///< undeformed
  Point normal;     ///< of length 1, out of the other element
  int joint_material = 0;
  double stiffness = 0;  ///< of the contact spring, force / length

  Point tangent() const { return {-normal.y, normal.x}; }
};

/// What the faces do to each other at a point, all per unit thickness.
struct FaceContact {
  FacePoint point;
  double gap = 0;           ///< of the faces, positive where they are apart; below 0 by the compression of the spring
  double slip = 0;          ///< of the element against the other, along the tangent
  double normal_force = 0;  ///< pressure positive; 0 where the faces are apart
  double shear_force = 0;   ///< on the element along the tangent
};

/// Three points of Gauss in each piece of face that is a side of one element on either side of the crack, the pieces at
/// its tip among them: without these the near-tip functions let the faces pass each other there, to a K_I of 5 to 20 %
/// of s √(π c) on sides of c/20 to c/4 at the tip (fra-19: compression s, flaw 2 c).
std::vector<FacePoint> face_points(const Continuum& continuum, const CoverBasis& basis);

/// Rows 2i and 2i + 1: gap and slip of point i by the unknowns of the basis, as shared ones.
ContactRows face_rows(const CoverBasis& basis, const std::vector<FacePoint>& points);

struct FaceForces {
  Eigen::VectorXd forces;  ///< normal and shear of each point, in turns
  bool converged = true;
};

/// Unilateral contact with Coulomb friction, both found together, of faces of bodies whose unknowns the loads alone
/// would make `d`: by the flexibility of the points, a solution with the factor of the stiffness for each force.
/// Friction acts against the whole slip, as under loads that grow in proportion; cohesion and tensile strength of the
/// joints are not looked at.
FaceForces face_forces(const std::vector<FacePoint>& points, const ContactRows& rows,
                       const std::vector<JointMaterial>& joints, std::shared_ptr<const SparseFactor> stiffness,
                       const Eigen::VectorXd& d);

/// The points with their forces, and how far faces are apart and have slipped where the unknowns are `d`.
std::vector<FaceContact> face_contacts(const std::vector<FacePoint>& points, const ContactRows& rows,
                                       const Eigen::VectorXd& forces, const Eigen::VectorXd& d);

}  // namespace keyblock
