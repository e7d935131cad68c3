// The displacement of points of a manifold from unknowns on its physical covers: u(x) = T(x) d, a polynomial in each
// element.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "geometry/polynomial.hpp"
#include "model/tips/tip_shape.hpp"
#include "problem/cover_plan.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

class TipEnrichment;

/// Names of the command line and of tables.
const char* name_of(CoverFunctions functions);

/// The displacement of one element. Both components are made of the same scalar functions, each of which carries two
/// unknowns, (dx, dy): u(x) = Σ N_a(x) d_a.
struct ElementShape {
  int degree = 1;                              ///< of the polynomials
  std::span<const int> functions;              ///< n of them, numbered in the whole manifold
  Eigen::Map<const Eigen::MatrixXd> monomial;  ///< monomials of the local coordinates × n
  LocalFrame frame;
  const TipShape* tip = nullptr;  ///< of functions that are no polynomials, the last ones; none in most elements

  int function_count() const { return static_cast<int>(functions.size()); }
  /// N, 1 × n.
  Eigen::RowVectorXd values(Point x) const;
  /// ∂N/∂x and ∂N/∂y, 2 × n, per length.
  Eigen::Matrix2Xd gradients(Point x) const;
  /// T, 2 × 2n: unknowns dx, dy of the first function, then of the second, …
  Eigen::Matrix2Xd displacement(Point x) const;
  /// B, 3 × 2n: engineering strain (ex, ey, gxy) = B d.
  Eigen::Matrix3Xd strain(Point x) const;
};

/// The functions of all elements. Extended beyond its element, a shape is the same polynomial.
class CoverBasis {
 public:
  CoverBasis(const Manifold& manifold, CoverFunctions functions, const TipFunctionPlan& tips = {});

  CoverFunctions functions() const { return functions_; }
  /// Those of an element: linear ones in place of derived ones about tips with functions.
  CoverFunctions functions(int element) const;
  bool has_tip_functions() const { return !tip_shapes_.empty(); }
  int degree() const { return degree_; }
  int function_count() const { return function_count_; }
  int element_count() const { return static_cast<int>(frames_.size()); }
  ElementShape shape(int element) const;

 private:
  void add(std::vector<int> functions, const Eigen::MatrixXd& monomial, const TipEnrichment* tips);
  void add_cover_polynomials(const Manifold& manifold, const TipEnrichment* tips);
  void add_derived(const Manifold& manifold, TipEnrichment* tips);

  CoverFunctions functions_;
  int degree_ = 1;
  int function_count_ = 0;
  std::vector<LocalFrame> frames_;
  std::vector<int> numbers_;  // of all elements, one after the other
  std::vector<double> coefficients_;
  std::vector<std::size_t> first_number_;
  std::vector<TipShape> tip_shapes_;
  std::vector<int> tip_shape_of_;  // of each element, -1: none; empty without any
  std::vector<char> is_linear_;    // elements of covers with gradients of their own among derived ones, likewise
};

}  // namespace keyblock
