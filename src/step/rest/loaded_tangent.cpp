// Assembled, then factorised in the order of the first; see loaded_tangent.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/loaded_tangent.hpp"

namespace keyblock {

const SparseLu& LoadedTangent::factor_at(const LoadedState& from, const Eigen::VectorXd& d, double elastic_share) {
  bodies_->put_tangent(from, d, elastic_share, tangent_);
  if (!factor_) factor_.emplace(tangent_.matrix());
  factor_->factorise(tangent_.matrix());
  return *factor_;
}

}  // namespace keyblock
