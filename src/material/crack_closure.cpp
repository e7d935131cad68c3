// Tries sets of closed cracks in turn; see crack_closure.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/crack_closure.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "material/principal_axes.hpp"

namespace keyblock {
namespace {

/// Returns by how much a stress contradicts the assumed set of closed cracks.
double contradiction(const CrackedElasticity& rock, const OfAxes& stress, const std::array<bool, 3>& closed) {
  double most = -std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < stress.size(); ++i) {
    const double beyond = stress(i) - rock.closing_stress();
    most = std::max(most, closed[static_cast<std::size_t>(i)] ? beyond : -beyond);
  }
  return most;
}

}  // namespace

CrackedState cracked_state(const CrackedElasticity& rock, const OfAxes& strain) {
  const Eigen::Index count = strain.size();
  ByAxes intact = ByAxes::Constant(count, count, -rock.poissons_ratio / rock.youngs_modulus);
  intact.diagonal().setConstant(1 / rock.youngs_modulus);
  std::array<Eigen::Index, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.begin() + count,
                   [&](Eigen::Index a, Eigen::Index b) { return strain(a) < strain(b); });
  const double closed_strain = rock.compliance() * rock.closing_stress();
  CrackedState best;
  double least = std::numeric_limits<double>::infinity();
  std::array<bool, 3> closed{};
  for (Eigen::Index set = 0; set <= count; ++set) {
    if (set > 0) closed[static_cast<std::size_t>(order[static_cast<std::size_t>(set - 1)])] = true;
    ByAxes compliance = intact;
    OfAxes rest = strain;
    for (Eigen::Index i = 0; i < count; ++i) {
      if (closed[static_cast<std::size_t>(i)])
        rest(i) -= closed_strain;
      else
        compliance(i, i) += rock.compliance();
    }
    const ByAxes stiffness = compliance.inverse();
    const OfAxes stress = stiffness * rest;
    const double wrong = contradiction(rock, stress, closed);
    if (!(wrong < least)) continue;
    least = wrong;
    best.stress = stress;
    best.stiffness = stiffness;
    best.closed = static_cast<int>(set);
    if (wrong <= 0) break;
  }
  best.cracks.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) best.cracks(i) = rock.crack_strain(best.stress(i));
  best.stored = best.stress.dot(intact * best.stress) / 2 + best.cracks.squaredNorm() / (2 * rock.compliance());
  return best;
}

CrackedResponse cracked_response(const CrackedElasticity& rock, const Eigen::Vector4d& strain, bool is_plane_stress) {
  const PlaneAxes axes(Eigen::Vector4d(strain(0), strain(1), strain(2) / 2, is_plane_stress ? 0 : strain(3)));
  const Eigen::Index count = is_plane_stress ? 2 : 3;
  const CrackedState state = cracked_state(rock, axes.values.head(count));
  Eigen::Vector3d stress = Eigen::Vector3d::Zero();
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  stress.head(count) = state.stress;
  normal.topLeftCorner(count, count) = state.stiffness;
  CrackedResponse response;
  response.strain = strain;
  if (is_plane_stress) response.strain(3) = -rock.poissons_ratio / rock.youngs_modulus * (stress(0) + stress(1));
  response.stress = axes.tensor(stress);
  response.tangent = isotropic_tangent(axes, stress, normal);
  response.stored = state.stored;
  response.closed = state.closed;
  response.possible = static_cast<int>(count);
  return response;
}

std::string why_unusable(const CrackClosure& closure, double youngs_modulus) {
  if (!(closure.initial_modulus > 0 && closure.initial_modulus < youngs_modulus))
    return fmt::format("expected initial_modulus of crack_closure: above 0 and below youngs_modulus {}, found {}",
                       youngs_modulus, closure.initial_modulus);
  if (!(closure.closure_strain > 0 && std::isfinite(closure.closure_strain)))
    return fmt::format("expected closure_strain of crack_closure: greater than 0, found {}", closure.closure_strain);
  return {};
}

}  // namespace keyblock
