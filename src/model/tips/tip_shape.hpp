// What near-tip functions add to the displacement of one element.
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

/// Functions λ_k F m: F the four near-tip functions of a tip on the element's branch of θ, m a combination of them.
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
  int first = 0;  ///< their place in the element's list, which they end

  /// Adds the values to those of the element's functions, which hold zeros there.
  void add_values(Point x, Eigen::RowVectorXd& values) const;
  /// The same of ∂/∂x and ∂/∂y.
  void add_gradients(Point x, Eigen::Matrix2Xd& gradients) const;
};

}  // namespace keyblock
