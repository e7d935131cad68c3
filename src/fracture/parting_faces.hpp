// New faces of a crack that let go of each other: the energy of fracture is taken while they part, not lost at once.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "problem/manifold.hpp"

namespace keyblock {

/// A point of both faces.
struct PartingPoint {
  Point at;            ///< undeformed
  Point pull;          ///< on the left face when the rock parted there, force per unit thickness; the right: opposite
  Point opening = {};  ///< displacement of the left face less that of the right, length
  int left = -1;       ///< elements of the manifold; -1: none is there
  int right = -1;
};

/// Displacement, length, of a point of an element of the manifold.
using DisplacementAt = std::function<Point(int, Point)>;

/// A piece that a crack gained in one increment. At first its faces pull each other as the rock did there, so that
/// nothing jumps when the scene is cut. The pull P of a point then points against x = δ + δ0 P/P, where δ is the
/// opening of the point and δ0 that of a tip at its toughness: faces that come to part in another direction than the
/// rock pulled are pulled against that one. What the full pulls would do as the faces part,
///     D = Σ P (|x| - δ0),
/// measures how far the piece has parted. All points together have the share f of their pulls, which falls linearly
/// with D from 1 - s to 0, so that the piece takes Γ in all (nodal release, Kobayashi, Emery & Mall 1976; linear
/// cohesive law, Hillerborg, Modéer & Petersson 1976). Faces that close again are pulled no more than
/// before, and not at all below D = 0: they give back less than they took. A little
/// of the pull, s, goes at once: a balance that nothing disturbs would last. Where rock was pressed across a piece as
/// it parted, its faces hold each other by little or nothing and would never take Γ: what lies wide open has parted
/// too.
struct PartingFaces {
  Point from;
  Point to;             ///< the left face lies to the left of the way to it
  double energy = 0;    ///< Γ, per unit thickness
  double wide = 0;      ///< farther apart than this all along, faces have parted
  double taken = 0;     ///< work that the pulls have done against the faces, per unit thickness
  double parted = 0;    ///< D, per unit thickness
  double farthest = 0;  ///< the greatest D so far
  std::vector<PartingPoint> points = {};

  /// D at which nothing is left to be taken.
  double end() const;
  bool have_parted() const { return farthest >= end(); }
  /// f at D.
  double share(double at) const;
  /// Work of the pulls on the way to D at which the law has it, per unit thickness.
  double work_at(double at) const;
  /// Puts D to where the law has the work taken: what a step took more or less does not add up.
  void put_to_taken();
  /// Of a step over which a point opens from its present opening to another: against this, of a length up to 1, a pull
  /// does the work that D says (discrete gradient, Gonzalez 1996).
  Point way(const PartingPoint& point, Point opening) const;
};

/// A piece with its pulls by the tractions of the rock before it parts. `energy`: Γ; `modulus`: E'. `traction`: on the
/// left face at a place, by what lies to the right of it, force per length² of the undeformed face; it is taken at the
/// middles of equal parts. What presses the faces together is left to contact: `along` the direction of the piece in
/// the deformed body.
PartingFaces parting_faces(Point from, Point to, double energy, double modulus, Point along,
                           const std::function<Point(Point)>& traction);

/// Puts the elements on both sides of the points, as bodies are cut now.
void put_elements(PartingFaces& faces, const Manifold& manifold);

/// Takes the present openings for those last looked at.
void look_at_openings(PartingFaces& faces, const DisplacementAt& displacement);

/// On the left faces of all pieces, in the order of their points, force per unit thickness.
using Pulls = std::vector<std::vector<Point>>;

/// Finds the pulls of a step in time: constant over it, with the share that does the work of the law between its start
/// and its end. With the share at its start instead a step in which faces open far takes many times Γ. Pieces move each
/// other's faces: their shares are found together.
class PullsOfStep {
 public:
  /// Begins with the pulls at the start of the step. Views the faces.
  explicit PullsOfStep(const std::vector<PartingFaces>& faces);

  const Pulls& pulls() const { return pulls_; }
  /// Of a step that was made with these pulls and ends with these displacements: true where they did the work of the
  /// law. Otherwise puts pulls that come nearer to it, and in the end those that came nearest, or none.
  bool are_found(const DisplacementAt& displacement);

 private:
  struct Trial {
    Eigen::VectorXd shares;
    Eigen::VectorXd asked;  ///< shares that would have done the work of the law on the way that the faces went
    double off = 0;         ///< of Γ: how far the work of a piece was from that of the law, at most; infinite where
                            ///< the piece gave back what it had not taken, or took more than Γ
    Pulls pulls;
  };
  Trial looked_at(const std::vector<std::vector<Point>>& openings) const;
  Eigen::VectorXd next_shares() const;

  const std::vector<PartingFaces>& faces_;
  Eigen::VectorXd shares_;
  Pulls pulls_;
  std::vector<Trial> tried_;
};

/// Ends a step that was made with these pulls of the faces: adds their work and puts the openings.
void part(PartingFaces& faces, const std::vector<Point>& pulls, const DisplacementAt& displacement);

}  // namespace keyblock
