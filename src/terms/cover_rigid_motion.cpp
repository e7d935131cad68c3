// Sums products with the mass matrix body by body; see cover_rigid_motion.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/cover_rigid_motion.hpp"

#include <cmath>
#include <utility>

namespace keyblock {
namespace {

Point pair_of(const Eigen::VectorXd& v, int function) {
  return {v(2 * function), v(2 * function + 1)};
}

}  // namespace

CoverRigidMotion::CoverRigidMotion(const Manifold& manifold, const CoverBasis& basis, SparseSystem mass)
    : functions_(manifold.body_materials.size()),
      functions_per_cover_(basis.function_count() / static_cast<int>(manifold.covers.size())),
      start_(Eigen::VectorXd::Zero(2 * basis.function_count())),
      mass_(std::move(mass)) {
  for (int f = 0; f < basis.function_count(); ++f) {
    const PhysicalCover& cover = manifold.covers[static_cast<std::size_t>(f / functions_per_cover_)];
    const int element = manifold.elements_of(cover).front();
    const int body = manifold.elements[static_cast<std::size_t>(element)].body;
    functions_[static_cast<std::size_t>(body)].push_back(f);
    const Point node = manifold.mesh.nodes[static_cast<std::size_t>(cover.node)];
    if (is_constant(f)) start_.segment<2>(2 * f) << node.x, node.y;
  }
}

std::vector<RigidMotion> CoverRigidMotion::motions(const Eigen::VectorXd& d, const Eigen::VectorXd& v) const {
  Eigen::VectorXd ones(start_.size());
  for (int f = 0; 2 * f < ones.size(); ++f) ones(2 * f) = ones(2 * f + 1) = one(f);
  const Eigen::VectorXd of_ones = mass_.times(ones);
  const Eigen::VectorXd of_velocity = mass_.times(v);
  Eigen::VectorXd arms = start_ + d;
  std::vector<RigidMotion> motions(functions_.size());
  for (std::size_t b = 0; b < functions_.size(); ++b) {
    RigidMotion& motion = motions[b];
    Point moment;
    for (const int f : functions_[b]) {
      motion.mass += one(f) * of_ones(2 * f);
      moment = moment + of_ones(2 * f) * pair_of(arms, f);
    }
    motion.centre = (1 / motion.mass) * moment;
    for (const int f : functions_[b])
      arms.segment<2>(2 * f) -= one(f) * Eigen::Vector2d(motion.centre.x, motion.centre.y);
  }
  const Eigen::VectorXd of_arms = mass_.times(arms);
  for (std::size_t b = 0; b < functions_.size(); ++b) {
    RigidMotion& motion = motions[b];
    for (const int f : functions_[b]) {
      motion.rotary_inertia += dot(pair_of(arms, f), pair_of(of_arms, f));
      motion.momentum = motion.momentum + one(f) * pair_of(of_velocity, f);
      motion.angular_momentum += cross(pair_of(arms, f), pair_of(of_velocity, f));
      motion.kinetic_energy += dot(pair_of(v, f), pair_of(of_velocity, f)) / 2;
    }
  }
  return motions;
}

Eigen::MatrixX3d CoverRigidMotion::modes(int body, const Eigen::VectorXd& d, Point centre) const {
  const std::vector<int>& functions = functions_[static_cast<std::size_t>(body)];
  Eigen::MatrixX3d modes(2 * static_cast<Eigen::Index>(functions.size()), 3);
  Eigen::Index i = 0;
  for (const int f : functions) {
    const Point arm = pair_of(start_, f) + pair_of(d, f) - one(f) * centre;
    modes.row(2 * i) << one(f), 0, -arm.y;
    modes.row(2 * i + 1) << 0, one(f), arm.x;
    ++i;
  }
  return modes;
}

Eigen::VectorXd CoverRigidMotion::turned(double angle, Point about, Point moved) const {
  Eigen::VectorXd d(start_.size());
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (int f = 0; 2 * f < d.size(); ++f) {
    const Point arm = pair_of(start_, f) - one(f) * about;
    const Point shift = Point{c * arm.x - s * arm.y, s * arm.x + c * arm.y} - arm + one(f) * moved;
    d.segment<2>(2 * f) << shift.x, shift.y;
  }
  return d;
}

}  // namespace keyblock
