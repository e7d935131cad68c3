// Computes the displacement of points of a manifold from the unknowns of its physical covers: u(x) = T(x) d, a
// polynomial in each element.
// Theory: docs/theory/08-manifold-method.md.
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

/// Returns the name used on the command line and in tables.
const char* name_of(CoverFunctions functions);

/// Displacement of one element. Both components use the same scalar functions, each with two unknowns (dx, dy): u(x) =
/// Σ N_a(x) d_a.
struct ElementShape {
  int degree = 1;                              ///< degree of the polynomials
  std::span<const int> functions;              ///< n function numbers, counted over the whole manifold
  Eigen::Map<const Eigen::MatrixXd> monomial;  ///< monomials of the local coordinates × n
  LocalFrame frame;
  const TipShape* tip = nullptr;  ///< of near-tip functions, which come last; null in most elements

  int function_count() const { return static_cast<int>(functions.size()); }
  /// Returns N, 1 × n.
  Eigen::RowVectorXd values(Point x) const;
  /// Returns ∂N/∂x and ∂N/∂y, 2 × n, per length.
  Eigen::Matrix2Xd gradients(Point x) const;
  /// Returns T, 2 × 2n: unknowns dx, dy of the first function, then of the second, …
  Eigen::Matrix2Xd displacement(Point x) const;
  /// Returns B, 3 × 2n: engineering strain (ex, ey, gxy) = B d.
  Eigen::Matrix3Xd strain(Point x) const;
};

/// Functions of all elements. A shape extends beyond its element as the same polynomial.
class CoverBasis {
 public:
  CoverBasis(const Manifold& manifold, CoverFunctions functions, const TipFunctionPlan& tips = {});

  CoverFunctions functions() const { return functions_; }
  /// Returns the kind of functions of an element: linear instead of derived near tips with functions.
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
  std::vector<int> tip_shape_of_;  // per element, -1: none; empty if no element has one
  std::vector<char> is_linear_;    // per element: covers have own gradients among derived ones; empty if no element has
};

}  // namespace keyblock
