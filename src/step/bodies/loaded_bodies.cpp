// Sums the forces of rock, springs, fixed edges and loads; see loaded_bodies.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/bodies/loaded_bodies.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "geometry/polygon.hpp"
#include "step/bodies/linear_static.hpp"
#include "terms/cover_loads.hpp"

namespace keyblock {
namespace {

FunctionGroups groups_of(const CoverBasis& basis, const std::vector<GhostPair>& pairs, const CoverYield& yield,
                         const HeldEdges& held) {
  FunctionGroups groups = coupled_functions(basis, pairs);
  yield.add_groups(groups);
  held.add_groups(groups);
  return groups;
}

int functions_per_cover(CoverFunctions functions) {
  if (functions == CoverFunctions::linear) return 3;
  return functions == CoverFunctions::quadratic ? 6 : 1;
}

}  // namespace

LoadedBodies::LoadedBodies(const Continuum& continuum)
    : continuum_(continuum),
      basis_(continuum_.manifold, continuum_.functions),
      elasticity_(continuum_, basis_),
      yield_(continuum_, basis_),
      held_(continuum_, basis_),
      ghost_pairs_(elastic_ghost_pairs(continuum_, basis_)),
      groups_(groups_of(basis_, ghost_pairs_, yield_, held_)),
      loads_(basis_.function_count(), groups_),
      stiffness_(basis_.function_count(), groups_) {
  add_cover_body_force(continuum_, basis_, loads_);
  for (const Traction& part : continuum_.tractions) add_traction(continuum_, basis_, part, loads_);
  for (const PointForce& force : continuum_.point_forces) add_point_force(basis_, force, loads_);
  for (const PointSpring& spring : continuum_.point_springs) add_point_spring(basis_, spring, stiffness_);
  held_.add_stiffness(stiffness_);
  add_ghost_penalty(continuum_, basis_, ghost_pairs_, stiffness_);
  unbalanced_ = Eigen::VectorXd::Zero(2 * basis_.function_count());
}

LoadedState LoadedBodies::at_start() const {
  return {Eigen::VectorXd::Zero(2 * basis_.function_count()), yield_.start()};
}

void LoadedBodies::begin(const LoadedState& start, const LoadedBodies* before) {
  unbalanced_.setZero();
  scale_at_start_ = 0;
  if (before != nullptr) held_.begin_after(before->held_, start.d);
  // R0 is zero here, so that the residual at load fraction 1 is R0, once fixed edges count as they are at fraction 0.
  const Balance all = balance(start, start.d, 1);
  unbalanced_ = all.residual + held_.pull(1, start.d.size()) - held_.pull(0, start.d.size());
  const Eigen::VectorXd rock = all.rock.force + elasticity_.force(start.d, start.d, 1);
  scale_at_start_ = std::max({rock.norm(), loads_.load().norm(), unbalanced_.norm()});
}

LoadedBodies::Balance LoadedBodies::balance(const LoadedState& from, const Eigen::VectorXd& d, double share) const {
  Balance sum;
  sum.rock = yield_.answer(d, from.points);
  const Eigen::VectorXd rock = sum.rock.force + elasticity_.force(d, d, 1);
  const Eigen::VectorXd held = stiffness_.times(d) - held_.pull(share, d.size());
  const Eigen::VectorXd loads = loads_.load() + (1 - share) * unbalanced_;
  sum.residual = rock + held - loads;
  sum.scale = std::max({rock.norm(), held.norm(), loads.norm(), scale_at_start_});
  if (!sum.rock.exists) sum.residual.setConstant(std::numeric_limits<double>::infinity());
  return sum;
}

Eigen::VectorXd LoadedBodies::scene_load() const {
  return held_.pull(1, unbalanced_.size()) - held_.pull(0, unbalanced_.size()) - unbalanced_;
}

WholeSystem LoadedBodies::tangent() const {
  return {basis_.function_count(), groups_};
}

void LoadedBodies::put_tangent(const LoadedState& from, const Eigen::VectorXd& d, double elastic_share,
                               WholeSystem& tangent) const {
  tangent.clear();
  yield_.add_tangent(d, from.points, elastic_share, tangent);
  SparseSystem symmetric = stiffness_;
  elasticity_.add_static_tangent(d, 1, symmetric);
  tangent.add(symmetric);
}

int LoadedBodies::turned_over(const Eigen::VectorXd& d) const {
  for (int e = 0; e < basis_.element_count(); ++e) {
    const auto loops = continuum_.manifold.polygon(continuum_.manifold.elements[static_cast<std::size_t>(e)]);
    if (!(elasticity_.deformation(d, e, centroid(loops.front())).determinant() > 0)) return e;
  }
  return -1;
}

ForceBalance LoadedBodies::forces(const Eigen::VectorXd& d, double share) const {
  ForceBalance balance;
  const Eigen::VectorXd loads = loads_.load() + (1 - share) * unbalanced_;
  const int per_cover = functions_per_cover(basis_.functions());
  // The constant functions of the covers alone move and rotate a whole body (cover_rigid_motion).
  for (int f = 0; f < basis_.function_count(); f += per_cover) {
    const PhysicalCover& cover = continuum_.manifold.covers[static_cast<std::size_t>(f / per_cover)];
    balance.loads.add(continuum_.manifold.mesh.nodes[static_cast<std::size_t>(cover.node)],
                      {loads(2 * f), loads(2 * f + 1)});
  }
  for (const PointSpring& spring : continuum_.point_springs) {
    const Point u = elasticity_.position(d, spring.element, spring.at) - spring.at;
    balance.springs.add(spring.at, (-spring.stiffness * dot(u, spring.direction)) * spring.direction);
  }
  balance.supports = held_.reactions(d, share);
  return balance;
}

void LoadedBodies::describe(Archive& archive) {
  archive.values("unbalanced_at_start", {unbalanced_.data(), static_cast<std::size_t>(unbalanced_.size())});
  archive.value("scale_at_start", scale_at_start_);
  Eigen::VectorXd held = held_.start();
  archive.values("held_at_start", {held.data(), static_cast<std::size_t>(held.size())});
  if (archive.is_restoring()) held_.set_start(held);
}

}  // namespace keyblock
