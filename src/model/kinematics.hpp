// Where the points of an element are under exact rotation: x = c + R(θ) (I + ε) X, X from the centroid at the start.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "geometry/simplex.hpp"
#include "model/cover_kinematics.hpp"
#include "model/model.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Unknowns of all blocks: displacement of the centroid, total angle, strain in the frame that turns with the block.
/// Elements that share unknowns have none of their own.
struct UnknownsTable : Table<ElementIndex, Unknowns> {
  using Table::Table;

  Eigen::VectorXd shared;  ///< (dx, dy) of each cover function; empty where nothing hangs on covers

  void set_zero();
  bool all_finite() const;
  UnknownsTable& operator*=(double factor);
  friend bool operator==(const UnknownsTable& a, const UnknownsTable& b);
};

/// The undeformed blocks, in coordinates of their own: constant during a run.
struct Reference {
  Table<ElementIndex, Point> centroids;
  Table<ElementIndex, Moments> moments;           ///< about the centroid
  Table<VertexIndex, Point> offsets;              ///< of the vertices from the centroid
  std::shared_ptr<const CoverKinematics> covers;  ///< of elements on covers; none where there are none

  bool is_on_covers(ElementIndex e) const { return covers && covers->carries(e); }
};

Reference reference_of(const Model& model, const Settings& settings);

Point turned(Point p, double angle);

/// The angle of the block frame; 0 for a basis without rotation.
double angle_of(const Basis& basis, const Unknowns& q);

/// Displacement of the centroid.
Point translation(const Basis& basis, const Unknowns& q);

/// ∂x/∂q at the material point X, 2 × n. The velocity of the point is this times the rate of q.
DisplacementOperator jacobian(const Basis& basis, const Unknowns& q, Point offset);

/// The map of one block at q: it moves many points for the price of a few. Blocks of few unknowns all lie in their one
/// affine map x = c + A X, A = R (I + ε).
class BlockMap {
 public:
  BlockMap(const Basis& basis, const Unknowns& q, Point centroid_at_start);

  /// x of the material point X.
  Point place(Point offset) const {
    return {centroid_.x + a_(0, 0) * offset.x + a_(0, 1) * offset.y,
            centroid_.y + a_(1, 0) * offset.x + a_(1, 1) * offset.y};
  }
  /// The X whose place is x.
  Point offset(Point place) const;
  /// R, of the turn of the block frame.
  const Eigen::Matrix2d& rotation() const { return rotation_; }
  /// A, of x by X.
  const Eigen::Matrix2d& gradient() const { return a_; }

 private:
  Point centroid_;
  Eigen::Matrix2d rotation_;
  Eigen::Matrix2d a_;
};

/// ∂x/∂q of the points of one block at q: linear in X.
class BlockJacobian {
 public:
  BlockJacobian(const Basis& basis, const Unknowns& q, const BlockMap& map);
  DisplacementOperator at(Point offset) const;

 private:
  DisplacementOperator constant_;
  DisplacementOperator per_x_;
  DisplacementOperator per_y_;
};

/// Where the point of an element lies that lay at `start`.
Point point_at(const Model& model, const Reference& reference, const UnknownsTable& q, ElementIndex element,
               Point start);

/// All vertices in the plane.
Table<VertexIndex, Point> vertices_at(const Model& model, const Reference& reference, const UnknownsTable& q);

double dot(const UnknownsTable& a, const UnknownsTable& b);

/// a + s b, element by element.
UnknownsTable plus(const UnknownsTable& a, double s, const UnknownsTable& b);

}  // namespace keyblock
