// Computes the positions of points of elements on covers: x = X + Σ N_a(X) d_a, with X on the undeformed manifold.
// Theory: docs/theory/01-kinematics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "model/cover_basis.hpp"
#include "model/model.hpp"

namespace keyblock {

/// Value of N_a at a point: its displacement per unit of the unknowns (dx, dy) of cover function a.
struct CoverShare {
  int function = 0;
  double value = 0;
};

/// Maps the elements of a model that use covers to the functions of their displacement.
class CoverKinematics {
 public:
  /// Matches element `first` of the model with element 0 of the basis, and so on to the last of both.
  CoverKinematics(const Model& model, ElementIndex first, const CoverBasis& basis);

  bool carries(ElementIndex e) const { return e.value >= first_.value; }
  int manifold_element(ElementIndex e) const { return e.value - first_.value; }
  Eigen::Index unknown_count() const { return 2 * Eigen::Index{basis_.function_count()}; }

  std::span<const CoverShare> of_vertex(VertexIndex v) const;
  /// Returns the functions at the point of an element that was at `start` initially.
  std::vector<CoverShare> shares(ElementIndex e, Point start) const;
  /// Returns the initial position of the point that is at `x` now; extended beyond the element by its polynomial.
  Point start_of(ElementIndex e, const Eigen::VectorXd& d, Point x) const;

 private:
  const CoverBasis& basis_;
  ElementIndex first_;
  VertexIndex first_vertex_;
  std::vector<CoverShare> shares_;  ///< of all vertices, one after another
  std::vector<std::size_t> begins_;
};

/// Returns the present position of the point that was at `start` initially.
Point moved(Point start, std::span<const CoverShare> shares, const Eigen::VectorXd& d);

}  // namespace keyblock
