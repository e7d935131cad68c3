// Adds near-tip functions to the displacement of one element.
// Theory: docs/theory/10-fracture.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/tips/near_tip_functions.hpp"

namespace keyblock {

/// λ_k of an element's triangle: 1 + gradient · (x - node).
struct CoverWeight {
  Point node;
  Point gradient;

  double at(Point x) const { return 1 + dot(gradient, x - node); }
};

/// Functions λ_k F m: F holds the four near-tip functions of a tip on the element's branch of θ, m is a combination of
/// them.
struct TipShape {
  struct Branch {
    TipAxes tip;
    double middle = 0;  ///< θ in the middle of the element
  };
  struct Function {
    CoverWeight weight;
    std::size_t branch = 0;
    Eigen::Vector4d mix;
  };
  std::vector<Branch> branches;
  std::vector<Point> tips;  ///< of the branches
  std::vector<Function> functions;
  int first = 0;  ///< their place in the element's list, at whose end they are

  /// Adds the values to those of the element's functions, which must be zero there.
  void add_values(Point x, Eigen::RowVectorXd& values) const;
  /// Adds ∂/∂x and ∂/∂y to the gradients of the element's functions.
  void add_gradients(Point x, Eigen::Matrix2Xd& gradients) const;
};

}  // namespace keyblock
