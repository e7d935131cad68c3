// New faces of a crack that let go of each other: the energy of fracture is taken while they part, not lost at once.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "problem/manifold.hpp"

namespace keyblock {

/// A point of both faces.
struct PartingPoint {
  Point at;    ///< undeformed
  Point pull;  ///< on the left face when the rock parted there, force per unit thickness; the right has the opposite
  Point apart = {};  ///< displacement of the left face less that of the right when last looked at
  int left = -1;     ///< elements of the manifold; -1: none is there
  int right = -1;
};

/// A piece that a crack gained in one increment. At first its faces pull each other as the rock did there, so that
/// nothing jumps when the scene is cut. All points let go together: their pulls have the share
///     f = √((1 - s) (1 - W/Γ)),
/// W the work that the pulls have taken and Γ the energy of fracture of the piece. Where points open in proportion this
/// is a traction that falls linearly with the opening and takes Γ in all (nodal release, Kobayashi, Emery & Mall 1976;
/// linear cohesive law, Hillerborg, Modéer & Petersson 1976). A little of the pull, s, goes at once: a balance that
/// nothing disturbs would last. Faces that close again are pulled no more than before. Where rock was pressed across a
/// piece as it parted, its faces hold each other by little or nothing and would never take Γ: what lies wide open has
/// parted too.
struct PartingFaces {
  Point from;
  Point to;           ///< the left face lies to the left of the way to it
  double energy = 0;  ///< Γ, per unit thickness
  double wide = 0;    ///< farther apart than this all along, faces have parted
  double taken = 0;   ///< W
  double share = 1;   ///< f; 0: they have parted
  std::vector<PartingPoint> points = {};

  bool have_parted() const { return share == 0; }
};

/// A piece with its pulls by the tractions of the rock before it parts. `energy`: Γ; `modulus`: E'. `traction`: on the
/// left face at a place, by what lies to the right of it, force per length² of the undeformed face; it is taken at the
/// middles of equal parts. What presses the faces together is left to contact: `along` the direction of the piece in
/// the deformed body.
PartingFaces parting_faces(Point from, Point to, double energy, double modulus, Point along,
                           const std::function<Point(Point)>& traction);

/// Puts the elements on both sides of the points, as bodies are cut now.
void put_elements(PartingFaces& faces, const Manifold& manifold);

/// Adds the work of openings since last looked at, lets the pulls go accordingly. `displacement`: of a point of an
/// element of the manifold.
void let_go(PartingFaces& faces, const std::function<Point(int, Point)>& displacement);

/// Takes the present openings for those last looked at.
void look_at_openings(PartingFaces& faces, const std::function<Point(int, Point)>& displacement);

}  // namespace keyblock
