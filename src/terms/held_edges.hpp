// Edges of bodies on covers that are held or moved by stiff springs: for rock whose stress no formula knows.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "model/continuum.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

/// P of the held component at a boundary with this outward normal.
Eigen::Matrix2d held_projector(Held held, Point normal);

/// Springs along the boundary, k P (u - g) per length with k = c M/h: M the modulus against strain in one direction, h
/// the size of the element's triangle, c that of `stabilisation` (penalty method; Babuška 1973). A support gives way by
/// traction/k, 1e-4 of what the element does. g goes from `from` to `to` in the scene.
///
/// Where an edge cuts triangles of constant functions, u there has a kink at every side that it crosses, and held
/// point by point it would leave the covers of those triangles no flow: what is held are means of u, weighted by hats
/// over stretches of at least 0.6 of a triangle's size each, or the whole edge where it is shorter (as multipliers on
/// cut meshes are coarsened: Béchet, Moës & Wohlmuth 2009). Their force acts at the centroid of the hat.
class HeldEdges {
 public:
  HeldEdges(const Continuum& continuum, const CoverBasis& basis);

  /// The functions of each mean couple.
  void add_groups(FunctionGroups& groups) const;

  /// Every edge begins where `before`, of the scene before, ended at the same place, and what was free where d has it.
  void begin_after(const HeldEdges& before, const Eigen::VectorXd& d);

  /// Where every edge began, (x, y) of one point after another.
  Eigen::VectorXd start() const;
  void set_start(const Eigen::VectorXd& start);

  void add_stiffness(SparseSystem& system) const;
  /// ∫ k Tᵀ P g at this share of the way.
  Eigen::VectorXd pull(double share, Eigen::Index size) const;
  /// The mean of |P g| over the springs of each prescribed displacement, by their stiffness: length.
  std::vector<double> driven(double share) const;
  /// What each prescribed displacement exerts on the bodies, moments about the origin at undeformed places.
  std::vector<Resultant> reactions(const Eigen::VectorXd& d, double share) const;

 private:
  /// A point, or a mean about one.
  struct HeldPoint {
    std::size_t part = 0;  ///< in Continuum::prescribed
    Point at;
    std::vector<int> functions;
    Eigen::RowVectorXd values;
    double stiffness = 0;  ///< k times the length it stands for
    Eigen::Matrix2d projector;
    Eigen::Vector2d from = Eigen::Vector2d::Zero();
    Eigen::Vector2d to;

    Eigen::Vector2d displacement(const Eigen::VectorXd& d) const;
    Eigen::Vector2d value(double share) const { return from + share * (to - from); }
  };

  struct Sides;  // of one prescribed displacement
  void add_points(const Sides& sides, const ElementSide& side);
  void add_means(const Sides& sides, std::span<const ElementSide> straight);

  std::size_t parts_ = 0;
  double near_ = 0;  // of two scenes, points nearer than this are one
  std::vector<HeldPoint> points_;
};

}  // namespace keyblock
