// Assembles the constant matrices; see elastic_bodies.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/bodies/elastic_bodies.hpp"

#include <utility>

#include "step/bodies/linear_static.hpp"
#include "terms/cover_inertia.hpp"
#include "terms/cover_loads.hpp"
#include "terms/ghost_force.hpp"
#include "terms/nitsche.hpp"

namespace keyblock {
namespace {

SparseSystem empty_system(const Continuum& continuum, const CoverBasis& basis) {
  return {basis.function_count(), coupled_functions(basis, ghost_pairs(continuum.manifold, basis))};
}

SparseSystem mass_of(const Continuum& continuum, const CoverBasis& basis) {
  SparseSystem mass = empty_system(continuum, basis);
  add_cover_mass(continuum, basis, mass);
  return mass;
}

SparseSystem ghost_of(const Continuum& continuum, const CoverBasis& basis) {
  SparseSystem ghost = empty_system(continuum, basis);
  add_ghost_penalty(continuum, basis, ghost_pairs(continuum.manifold, basis), ghost);
  return ghost;
}

SparseSystem supports_of(const Continuum& continuum, const CoverBasis& basis) {
  SparseSystem supports = empty_system(continuum, basis);
  add_supports_and_loads(continuum, basis, supports);
  return supports;
}

}  // namespace

ElasticBodies::ElasticBodies(Continuum with_loads, CoverDamping with_damping)
    : continuum(std::move(with_loads)),
      damping(with_damping),
      elasticity(continuum, CoverBasis(continuum.manifold, continuum.functions)),
      mass(mass_of(continuum, basis())),
      ghost(ghost_of(continuum, basis())),
      supports(supports_of(continuum, basis())),
      rigid(continuum.manifold, basis(), mass) {}

Eigen::VectorXd ElasticBodies::force(const Eigen::VectorXd& d0, const Eigen::VectorXd& d1, double strain,
                                     double weight) const {
  return elasticity.force(d0, d1, strain) + ghost_force(ghost, rigid.functions(), d0, d1, weight) +
         supports.times(d0 + weight * (d1 - d0));
}

double ElasticBodies::energy(const Eigen::VectorXd& d) const {
  return elasticity.energy(d) + d.dot(ghost.times(d) + supports.times(d)) / 2;
}

}  // namespace keyblock
