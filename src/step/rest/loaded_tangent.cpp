// Assembles the tangent and factorises it in the elimination order of the first; see loaded_tangent.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/loaded_tangent.hpp"

#include "base/context.hpp"
#include "step/bodies/linear_static.hpp"

namespace keyblock {

// Cholesky needs independent unknowns, or the matrix is singular.
LoadedTangent::LoadedTangent(const LoadedBodies& bodies)
    : bodies_(&bodies),
      is_symmetric_(bodies.yield().functions_of_whole_tangents().empty() &&
                    definiteness_of(bodies.basis().functions()) == Definiteness::definite),
      tangent_(bodies.tangent()) {}

const LinearFactor& LoadedTangent::factor_at(const LoadedState& from, const Eigen::VectorXd& d, double elastic_share) {
  begin_system();
  bodies_->put_tangent(from, d, elastic_share, tangent_);
  if (is_symmetric_) {
    try {
      const Eigen::SparseMatrix<double> lower = tangent_.matrix().triangularView<Eigen::Lower>();
      if (!symmetric_) symmetric_.emplace(lower, Definiteness::definite);
      symmetric_->factorise(lower);
      return *symmetric_;
    } catch (const NotPositiveDefinite&) {  // softening rock: LU may still succeed
    }
  }
  if (!factor_) factor_.emplace(tangent_.matrix());
  factor_->factorise(tangent_.matrix());
  return *factor_;
}

}  // namespace keyblock
