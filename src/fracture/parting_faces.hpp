// Releases the new faces of a crack gradually, so that the fracture energy is dissipated while they separate, not at
// once. Theory: docs/theory/10-fracture.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "problem/manifold.hpp"

namespace keyblock {

/// Point of both faces.
struct PartingPoint {
  Point at;            ///< undeformed
  Point pull;          ///< on the left face as the rock parted there, force per unit thickness; on the right: opposite
  Point opening = {};  ///< displacement of the left face minus that of the right [length]
  int left = -1;       ///< elements of the manifold; -1: no element there
  int right = -1;
};

/// Displacement [length] of a point of an element of the manifold.
using DisplacementAt = std::function<Point(int, Point)>;

/// Piece that a crack gained in one increment.
///
/// At first its faces pull each other as the rock did there, so that no force jumps when the scene is cut. The pull P
/// of a point then acts against x = δ + δ0 P/P. δ is the opening of the point, and δ0 that of a tip at its toughness.
/// Faces that separate in another direction than the rock pulled are therefore pulled against that direction. The work
/// of the full pulls as the faces separate,
///       D = Σ P (|x| - δ0),
/// measures how far the piece has separated. All points together have the fraction f of their pulls. It falls linearly
/// with D from 1 - s to 0, so that the piece dissipates Γ in all (nodal release, Kobayashi, Emery & Mall 1976; linear
/// cohesive law, Hillerborg, Modéer & Petersson 1976). Faces that close again are pulled no more than before, and not
/// at all below D = 0: they give back less than they took. A small fraction s of the pull is released at once, because
/// an undisturbed balance would last. If rock was pressed across a piece as it parted, its faces pull each other by
/// little or nothing and would never dissipate Γ. A piece that lies wide open has therefore parted too.
struct PartingFaces {
  Point from;
  Point to;             ///< the left face lies to the left of the direction from `from` to `to`
  double energy = 0;    ///< Γ, per unit thickness
  double wide = 0;      ///< faces that are farther apart than this everywhere have parted
  double taken = 0;     ///< work of the pulls against the faces, per unit thickness
  double parted = 0;    ///< D, per unit thickness
  double farthest = 0;  ///< the greatest D so far
  std::vector<PartingPoint> points = {};

  /// Returns D at which the pulls have vanished.
  double end() const;
  bool have_parted() const { return farthest >= end(); }
  /// Returns f at D.
  double share(double at) const;
  /// Returns the work of the pulls up to D by the law, per unit thickness.
  double work_at(double at) const;
  /// Sets D to the value at which the law has the work taken, so that errors of the steps do not add up.
  void put_to_taken();
  /// Returns a direction of length up to 1 for a step in which a point opens from its present opening to another. A
  /// pull against it does the work given by D (discrete gradient, Gonzalez 1996).
  Point way(const PartingPoint& point, Point opening) const;
};

/// Returns a piece whose pulls are the tractions of the rock before it parts. `energy`: Γ; `modulus`: E'. `traction`:
/// traction on the left face at a place, exerted by the right side [force per length² of the undeformed face]; it is
/// evaluated at the middles of equal parts. Pressure between the faces is left to contact. `along`: direction of the
/// piece in the deformed body.
PartingFaces parting_faces(Point from, Point to, double energy, double modulus, Point along,
                           const std::function<Point(Point)>& traction);

/// Sets the elements on both sides of the points, for the present cut of the bodies.
void put_elements(PartingFaces& faces, const Manifold& manifold);

/// Sets the stored openings to the present ones.
void look_at_openings(PartingFaces& faces, const DisplacementAt& displacement);

/// Pulls on the left faces of all pieces, in the order of their points [force per unit thickness].
using Pulls = std::vector<std::vector<Point>>;

/// Finds the pulls of a time step: constant over it, with the fraction that does the work of the law between its start
/// and its end. With the fraction at its start instead, a step in which faces open far would dissipate many times Γ.
/// Pieces move each other's faces, so their fractions are found together.
class PullsOfStep {
 public:
  /// Begins with the pulls at the start of the step. Keeps a reference to the faces.
  explicit PullsOfStep(const std::vector<PartingFaces>& faces);

  const Pulls& pulls() const { return pulls_; }
  /// Tests a step made with these pulls that ends with these displacements; returns true if they did the work of the
  /// law. Otherwise sets pulls that come nearer to it, and at the end those that came nearest, or none.
  bool are_found(const DisplacementAt& displacement);

 private:
  struct Trial {
    Eigen::VectorXd shares;
    Eigen::VectorXd asked;  ///< fractions that would have done the work of the law for this motion of the faces
    double off = 0;  ///< per Γ: greatest difference between the work of a piece and that of the law; infinite if
                     ///< the piece gave back more than it had taken, or took more than Γ
    Pulls pulls;
  };
  Trial looked_at(const std::vector<std::vector<Point>>& openings) const;
  Eigen::VectorXd next_shares() const;

  const std::vector<PartingFaces>& faces_;
  Eigen::VectorXd shares_;
  Pulls pulls_;
  std::vector<Trial> tried_;
};

/// Ends a step made with these pulls of the faces: adds their work and sets the openings.
void part(PartingFaces& faces, const std::vector<Point>& pulls, const DisplacementAt& displacement);

}  // namespace keyblock
