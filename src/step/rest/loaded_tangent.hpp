// Holds the tangent of loaded bodies and its factorisation for all searches of a scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>

#include "step/bodies/loaded_bodies.hpp"
#include "step/newton/newton.hpp"
#include "system/cholmod/sparse_factor.hpp"
#include "system/sparse_lu.hpp"

namespace keyblock {

/// Returns the residual over the largest force.
inline double share_out_of_balance(const LoadedBodies::Balance& balance) {
  const double residual = balance.residual.norm();
  return residual == 0 ? 0 : residual / balance.scale;
}

/// Returns the state of a Newton iteration with this relative residual.
inline RoundsEnd state_of(double left) {
  if (left <= tolerances::of_newton::kBalanced) return RoundsEnd::balanced;
  return std::isfinite(left) ? RoundsEnd::open : RoundsEnd::not_finite;
}

/// Factorises by Cholesky if every law has a symmetric tangent and the matrix is positive definite, else by LU. One
/// object serves all steps of a scene and keeps the elimination orders.
class LoadedTangent {
 public:
  explicit LoadedTangent(const LoadedBodies& bodies);

  const LoadedBodies& bodies() const { return *bodies_; }
  /// Returns the factorisation at d, with a fraction of the elastic stiffness added. Throws SingularMatrix.
  const LinearFactor& factor_at(const LoadedState& from, const Eigen::VectorXd& d, double elastic_share = 0);

 private:
  const LoadedBodies* bodies_;
  bool is_symmetric_ = false;
  WholeSystem tangent_;
  std::optional<SparseFactor> symmetric_;
  std::optional<SparseLu> factor_;
};

}  // namespace keyblock
