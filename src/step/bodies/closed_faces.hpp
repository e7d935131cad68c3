// Finds the contacts between the two faces of each crack, and their normal and friction forces in a linear static
// solution. Theory: docs/theory/10-fracture.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "contact/rows/contact_row.hpp"
#include "model/continuum.hpp"
#include "system/cholmod/sparse_factor.hpp"

namespace keyblock {

/// Contact point inside a piece that belongs to both faces of a crack; the faces coincide before any load.
struct FacePoint {
  int element = 0;  ///< of the manifold
  int other = 0;    ///< element across the crack
  int edge = 0;     ///< of the other element, by the corner at its end, counted through its loops from 0
  Point at;         ///< undeformed
  Point normal;     ///< unit vector out of the other element
  int joint_material = 0;
  double stiffness = 0;  ///< contact spring, force / length

  Point tangent() const { return {-normal.y, normal.x}; }
};

/// Contact state of the faces at a point; forces per unit thickness.
struct FaceContact {
  FacePoint point;
  double gap = 0;           ///< positive if the faces are apart; negative by the compression of the spring
  double slip = 0;          ///< of the element against the other, along the tangent
  double normal_force = 0;  ///< pressure positive; 0 if the faces are apart
  double shear_force = 0;   ///< on the element along the tangent
};

/// Returns three Gauss points per piece of face that is a side of one element on each side of the crack. The pieces at
/// the crack tip are included. Without them the near-tip functions let the faces overlap there, and K_I becomes 5 to 20
/// % of s √(π c). Measured on sides of c/20 to c/4 at the tip (fra-19: compression s, flaw 2 c).
std::vector<FacePoint> face_points(const Continuum& continuum, const CoverBasis& basis);

/// Returns rows 2i and 2i + 1: gap and slip of point i in terms of the unknowns of the basis, which all are shared.
ContactRows face_rows(const CoverBasis& basis, const std::vector<FacePoint>& points);

struct FaceForces {
  Eigen::VectorXd forces;  ///< normal and shear force of each point, alternating
  bool converged = true;
};

/// Solves for unilateral contact with Coulomb friction, both at once. `d`: unknowns under the loads without contact.
/// The flexibility of the points takes one solution with the factorised stiffness per force. Friction opposes the whole
/// slip, as under loads that grow in proportion. Cohesion and tensile strength of the joints are ignored.
FaceForces face_forces(const std::vector<FacePoint>& points, const ContactRows& rows,
                       const std::vector<JointMaterial>& joints, std::shared_ptr<const SparseFactor> stiffness,
                       const Eigen::VectorXd& d);

/// Returns the points with their forces, gaps and slips at the unknowns `d`.
std::vector<FaceContact> face_contacts(const std::vector<FacePoint>& points, const ContactRows& rows,
                                       const Eigen::VectorXd& forces, const Eigen::VectorXd& d);

}  // namespace keyblock
