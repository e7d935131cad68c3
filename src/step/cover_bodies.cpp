// Assembles the constant matrices; see cover_bodies.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/cover_bodies.hpp"

#include <utility>

#include "step/linear_static.hpp"
#include "terms/cover_inertia.hpp"
#include "terms/cover_loads.hpp"
#include "terms/nitsche.hpp"

namespace keyblock {
namespace {

SparseSystem mass_of(const Continuum& continuum, const CoverBasis& basis) {
  SparseSystem mass(basis.function_count(), coupled_functions(basis, ghost_pairs(continuum.manifold, basis)));
  add_cover_mass(continuum, basis, mass);
  return mass;
}

SparseSystem constant_of(const Continuum& continuum, const CoverBasis& basis) {
  const std::vector<GhostPair> pairs = ghost_pairs(continuum.manifold, basis);
  SparseSystem system(basis.function_count(), coupled_functions(basis, pairs));
  add_ghost_penalty(continuum, basis, pairs, system);
  add_supports_and_loads(continuum, basis, system);
  return system;
}

}  // namespace

CoverBodies::CoverBodies(Continuum with_loads, CoverDamping with_damping)
    : continuum(std::move(with_loads)),
      damping(with_damping),
      elasticity(continuum, CoverBasis(continuum.manifold, continuum.functions)),
      mass(mass_of(continuum, basis())),
      constant(constant_of(continuum, basis())),
      rigid(continuum.manifold, basis(), mass) {}

double CoverBodies::energy(const Eigen::VectorXd& d) const {
  return elasticity.energy(d) + d.dot(constant.times(d)) / 2;
}

}  // namespace keyblock
