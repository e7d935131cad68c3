// Where the points of elements on covers are: x = X + Σ N_a(X) d_a, X on the undeformed manifold.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "model/cover_basis.hpp"
#include "model/model.hpp"

namespace keyblock {

/// N_a at a point: what a unit of the unknowns (dx, dy) of cover function a moves it by.
struct CoverShare {
  int function = 0;
  double value = 0;
};

/// The elements of a model that hang on covers, with the functions of their displacement.
class CoverKinematics {
 public:
  /// Element `first` of the model is element 0 of the basis, and so on to the last of both.
  CoverKinematics(const Model& model, ElementIndex first, const CoverBasis& basis);

  bool carries(ElementIndex e) const { return e.value >= first_.value; }
  int manifold_element(ElementIndex e) const { return e.value - first_.value; }
  Eigen::Index unknown_count() const { return 2 * Eigen::Index{basis_.function_count()}; }

  std::span<const CoverShare> of_vertex(VertexIndex v) const;
  /// At the point of an element that lay at `start`.
  std::vector<CoverShare> shares(ElementIndex e, Point start) const;
  /// Where the point lay at the start that lies at `x` now; extended beyond the element as its polynomial is.
  Point start_of(ElementIndex e, const Eigen::VectorXd& d, Point x) const;

 private:
  const CoverBasis& basis_;
  ElementIndex first_;
  VertexIndex first_vertex_;
  std::vector<CoverShare> shares_;  ///< of all vertices, one after another
  std::vector<std::size_t> begins_;
};

/// Where a point lies that lay at `start`.
Point moved(Point start, std::span<const CoverShare> shares, const Eigen::VectorXd& d);

}  // namespace keyblock
