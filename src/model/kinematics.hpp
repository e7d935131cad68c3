// Computes the positions of points of an element under exact rotation: x = c + R(θ) (I + ε) X, with X from the initial
// centroid.
// Theory: docs/theory/01-kinematics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "geometry/simplex.hpp"
#include "model/cover_kinematics.hpp"
#include "model/model.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Unknowns of all blocks: displacement of the centroid, total angle, and strain in the frame that rotates with the
/// block. Elements that share unknowns have none of their own.
struct UnknownsTable : Table<ElementIndex, Unknowns> {
  using Table::Table;

  Eigen::VectorXd shared;  ///< (dx, dy) of each cover function; empty without elements on covers

  void set_zero();
  bool all_finite() const;
  UnknownsTable& operator*=(double factor);
  friend bool operator==(const UnknownsTable& a, const UnknownsTable& b);
};

/// Undeformed blocks, in coordinates of their own; constant during a run.
struct Reference {
  Table<ElementIndex, Point> centroids;
  Table<ElementIndex, Moments> moments;           ///< about the centroid
  Table<VertexIndex, Point> offsets;              ///< of the vertices from the centroid
  std::shared_ptr<const CoverKinematics> covers;  ///< of elements on covers; null without them

  bool is_on_covers(ElementIndex e) const { return covers && covers->carries(e); }
};

Reference reference_of(const Model& model, const Settings& settings);

Point turned(Point p, double angle);

/// Returns the angle of the block frame; 0 for a basis without rotation.
double angle_of(const Basis& basis, const Unknowns& q);

/// Returns the displacement of the centroid.
Point translation(const Basis& basis, const Unknowns& q);

/// Returns ∂x/∂q at the material point X, 2 × n. The velocity of the point is this times the rate of q.
DisplacementOperator jacobian(const Basis& basis, const Unknowns& q, Point offset);

/// Map of one block at q, for moving many points at low cost. Blocks of few unknowns have one affine map x = c + A X, A
/// = R (I + ε).
class BlockMap {
 public:
  BlockMap(const Basis& basis, const Unknowns& q, Point centroid_at_start);

  /// Returns x of the material point X.
  Point place(Point offset) const {
    return {centroid_.x + a_(0, 0) * offset.x + a_(0, 1) * offset.y,
            centroid_.y + a_(1, 0) * offset.x + a_(1, 1) * offset.y};
  }
  /// Returns the material point X at the position x.
  Point offset(Point place) const;
  /// Returns R, the rotation of the block frame.
  const Eigen::Matrix2d& rotation() const { return rotation_; }
  /// Returns A = ∂x/∂X.
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

/// Returns the present position of the point of an element that was at `start` initially.
Point point_at(const Model& model, const Reference& reference, const UnknownsTable& q, ElementIndex element,
               Point start);

/// Returns the positions of all vertices.
Table<VertexIndex, Point> vertices_at(const Model& model, const Reference& reference, const UnknownsTable& q);

double dot(const UnknownsTable& a, const UnknownsTable& b);

/// Returns a + s b, element by element.
UnknownsTable plus(const UnknownsTable& a, double s, const UnknownsTable& b);

}  // namespace keyblock
