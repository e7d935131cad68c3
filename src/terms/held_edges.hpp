// Supports or moves edges of NMM bodies by stiff springs, for rock whose stress has no formula.
// Theory: docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "model/continuum.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

/// Returns P of the fixed component at a boundary with this outward normal.
Eigen::Matrix2d held_projector(Held held, Point normal);

/// Springs along the boundary, k P (u - g) per length with k = c M/h (penalty method; Babuška 1973). M is the modulus
/// against strain in one direction, h the size of the element's triangle, c that of `stabilisation`. A support yields
/// by traction/k, 1e-4 of the displacement of the element. g runs from `from` to `to` in the scene.
///
/// If an edge cuts triangles of constant functions, u has a kink at every side that it crosses. Fixed point by point,
/// it would leave the covers of those triangles no plastic flow. The springs therefore act on means of u, weighted by
/// hats. Each hat covers at least 0.6 of a triangle's size, or the whole edge if that is shorter. (Multipliers on cut
/// meshes are coarsened in this way: Béchet, Moës & Wohlmuth 2009.) The force of a mean acts at the centroid of its
/// hat.
class HeldEdges {
 public:
  HeldEdges(const Continuum& continuum, const CoverBasis& basis);

  /// Adds the functions that each mean couples.
  void add_groups(FunctionGroups& groups) const;

  /// Makes every edge begin where `before`, of the scene before, ended at the same place. Edges that were free begin at
  /// d.
  void begin_after(const HeldEdges& before, const Eigen::VectorXd& d);

  /// Returns the start of every edge, (x, y) of one point after another.
  Eigen::VectorXd start() const;
  void set_start(const Eigen::VectorXd& start);

  void add_stiffness(SparseSystem& system) const;
  /// Returns ∫ k Tᵀ P g at this fraction of the motion.
  Eigen::VectorXd pull(double share, Eigen::Index size) const;
  /// Returns the mean of |P g| over the springs of each prescribed displacement, weighted by stiffness [length].
  std::vector<double> driven(double share) const;
  /// Returns the force of each prescribed displacement on the bodies, with moments about the origin at undeformed
  /// places.
  std::vector<Resultant> reactions(const Eigen::VectorXd& d, double share) const;

 private:
  /// Point, or mean around one.
  struct HeldPoint {
    std::size_t part = 0;  ///< index into Continuum::prescribed
    Point at;
    std::vector<int> functions;
    Eigen::RowVectorXd values;
    double stiffness = 0;  ///< k times the length of its part
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
  double near_ = 0;  // points of two scenes nearer than this are the same
  std::vector<HeldPoint> points_;
};

}  // namespace keyblock
