// Assembles the constant matrices; see elastic_bodies.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/bodies/elastic_bodies.hpp"

#include <algorithm>
#include <utility>

#include "step/bodies/linear_static.hpp"
#include "terms/cover_inertia.hpp"
#include "terms/cover_loads.hpp"
#include "terms/ghost_force.hpp"
#include "terms/nitsche.hpp"

namespace keyblock {
namespace {

SparseSystem ghost_of(const Continuum& continuum, const CoverBasis& basis, const CoverYield& yield) {
  const std::vector<GhostPair> pairs = elastic_ghost_pairs(continuum, basis);
  FunctionGroups groups = coupled_functions(basis, pairs);
  yield.add_groups(groups);
  SparseSystem ghost(basis.function_count(), groups);
  add_ghost_penalty(continuum, basis, pairs, ghost);
  return ghost;
}

/// Returns a zero system with the same groups of functions.
SparseSystem empty_like(SparseSystem other) {
  other.clear();
  return other;
}

SparseSystem mass_of(const Continuum& continuum, const CoverBasis& basis, SparseSystem mass) {
  add_cover_mass(continuum, basis, mass);
  return mass;
}

SparseSystem supports_of(const Continuum& continuum, const CoverBasis& basis, SparseSystem supports) {
  add_supports_and_loads(continuum, basis, supports);
  return supports;
}

bool damps(const std::vector<double>& of_bodies) {
  return std::ranges::any_of(of_bodies, [](double share) { return share != 0; });
}

}  // namespace

ElasticBodies::ElasticBodies(Continuum with_loads, const CoverDamping& damping)
    : continuum(std::move(with_loads)),
      elasticity(continuum, CoverBasis(continuum.manifold, continuum.functions)),
      yield(continuum, basis()),
      ghost(ghost_of(continuum, basis(), yield)),
      mass(mass_of(continuum, basis(), empty_like(ghost))),
      has_mass_damping(damps(damping.mass)),
      mass_damping(has_mass_damping ? empty_like(ghost) : SparseSystem(0, {})),
      supports(supports_of(continuum, basis(), empty_like(ghost))),
      rigid(continuum.manifold, basis(), mass) {
  if (has_mass_damping) {
    std::vector<double> of_functions(static_cast<std::size_t>(basis().function_count()));
    for (std::size_t body = 0; body < rigid.functions().size(); ++body)
      for (const int f : rigid.functions()[body]) of_functions[static_cast<std::size_t>(f)] = damping.mass[body];
    mass_damping.add_scaled(of_functions, mass);
  }
  if (damps(damping.stiffness))
    for (const ManifoldElement& element : continuum.manifold.elements)
      stiffness_damping.push_back(damping.stiffness[static_cast<std::size_t>(element.body)]);
}

Eigen::VectorXd ElasticBodies::force(const CoverYield::Way& way) const {
  Eigen::VectorXd sum = elasticity.force(way.d0, way.d1, way.theta, way.more) +
                        ghost_force(ghost, rigid.functions(), way.d0, way.d1, way.theta) +
                        supports.times(way.d0 + way.theta * (way.d1 - way.d0));
  if (!yield.is_empty()) sum += yield.force_of_step(way);
  return sum;
}

Eigen::VectorXd ElasticBodies::force(const Eigen::VectorXd& d, const YieldStates& points) const {
  return force({d, points, d});
}

double ElasticBodies::energy(const Eigen::VectorXd& d, const YieldStates& points) const {
  const double elastic = elasticity.energy(d) + d.dot(ghost.times(d) + supports.times(d)) / 2;
  return yield.is_empty() ? elastic : elastic + yield.stored(d, points);
}

}  // namespace keyblock
