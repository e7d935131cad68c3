// Sums over blocks; each has one small vector of unknowns.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/groups/block_bodies.hpp"

#include <algorithm>
#include <cmath>

#include "base/worse.hpp"

namespace keyblock {
namespace {

double half_square(const UnknownBlock& matrix, const Unknowns& x) {
  return x.dot(matrix * x) / 2;
}

double size_of_force(const Unknowns& force, double size) {
  if (force.size() == 0) return 0;
  return worse(force.head<2>().stableNorm(),
               force.tail(force.size() - 2).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() / size);
}

double greatest(const Unknowns& change, double size) {
  return worse(change.head<2>().maxCoeff<Eigen::PropagateNaN>() / size,
               change.tail(change.size() - 2).maxCoeff<Eigen::PropagateNaN>());
}

}  // namespace

void add_block(Scales& scales, const Body& body, const Unknowns& load, const Unknowns& v) {
  const double mass = body.mass(0, 0);
  const double force = std::hypot(load[0], load[1]) + std::abs(load[2]) / body.size;
  scales.force = std::max(scales.force, force);
  scales.acceleration = std::max(scales.acceleration, force / mass);
  scales.momentum = std::max(scales.momentum, mass * (v.head<2>().norm() + body.size * std::abs(v[2])));
  scales.size = std::max(scales.size, body.size);
}

double largest_load(const Body& body, const Unknowns& load) {
  return std::max(size_of_force(load, body.size), size_of_force(body.initial_stress, body.size));
}

BlockBodies::BlockBodies(Bodies bodies, std::vector<bool> of_others)
    : bodies_(std::move(bodies)), of_others_(std::move(of_others)) {
  for (const Body& body : bodies_)
    if (body.mass.rows() > 0) size_ = std::max(size_, body.size);
}

bool BlockBodies::has_supports() const {
  for (ElementIndex e : indices(bodies_))
    if (has(e) && bodies_[e].mass.rows() == 0) return true;
  return false;
}

void BlockBodies::add_to(MassRange& range, double contact_stiffness) const {
  for (const Body& body : bodies_) {
    const Eigen::Index last = body.mass.rows() - 1;
    if (last < 0) continue;
    range.lightest = std::min(range.lightest, body.mass(0, 0));
    range.heaviest = std::max(range.heaviest, body.mass(0, 0));
    range.all_strain = range.all_strain && body.slowest_frequency > 0;
    if (body.strain_count() > 0)
      range.slowest =
          std::min(range.slowest, std::sqrt(body.stiffness.diagonal().tail<1>()[0] / body.mass(last, last)));
    if (contact_stiffness > 0) range.slowest = std::min(range.slowest, std::sqrt(contact_stiffness / body.mass(0, 0)));
  }
}

void BlockBodies::carry_over(const SceneParts& scene, UnknownsTable& v) const {
  for (ElementIndex e : indices(v)) v[e] *= scene.settings.velocity_carry_over.of(scene.model.elements[e].material);
}

void BlockBodies::put_own_loads(const UnknownsTable&, double, UnknownsTable& loads) const {
  loads.reserve(bodies_.size());
  for (const Body& body : bodies_) loads.push_back(body.weight);
}

void BlockBodies::add_inertia(Point acceleration, UnknownsTable& loads) const {
  for (ElementIndex e : indices(loads))
    if (loads[e].size() > 0)
      loads[e].head<2>() += bodies_[e].mass(0, 0) * Eigen::Vector2d(acceleration.x, acceleration.y);
}

void BlockBodies::add_to(Scales& scales, const UnknownsTable& loads, const UnknownsTable&,
                         const UnknownsTable& v) const {
  for (ElementIndex e : indices(loads))
    if (loads[e].size() > 0) add_block(scales, bodies_[e], loads[e], v[e]);
}

void BlockBodies::put_mass_inverse(Flexibility& flexibility) const {
  flexibility.blocks = mass_inverses(bodies_);
}

void BlockBodies::put_momentum(const UnknownsTable& v, UnknownsTable& momentum) const {
  momentum.resize(v.size());
  for (ElementIndex e : indices(v)) momentum[e] = bodies_[e].mass * v[e];
}

double BlockBodies::kinetic_energy(const UnknownsTable& v) const {
  double energy = 0;
  for (ElementIndex e : indices(v))
    if (v[e].size() > 0) energy += half_square(bodies_[e].mass, v[e]);
  return energy;
}

double BlockBodies::largest_momentum(const UnknownsTable& v) const {
  double largest = 0;
  for (ElementIndex e : indices(v))
    if (v[e].size() > 0) largest = std::max(largest, (bodies_[e].mass * v[e]).head<2>().norm());
  return largest;
}

double BlockBodies::largest_load(const UnknownsTable& loads) const {
  double largest = 0;
  for (ElementIndex e : indices(loads)) largest = std::max(largest, keyblock::largest_load(bodies_[e], loads[e]));
  return largest;
}

void BlockBodies::look_at_forces(const UnknownsTable& a, const SeenForce& seen) const {
  for (ElementIndex e : indices(a))
    if (has(e)) seen(e, size_of_force(bodies_[e].mass * a[e], bodies_[e].size));
}

void BlockBodies::look_at_bodies(const SceneParts& scene, const UnknownsTable& q, const UnknownsTable& forces,
                                 const SeenBody& seen) const {
  for (ElementIndex e : indices(bodies_)) {
    const Body& body = bodies_[e];
    if (body.mass.rows() == 0) continue;
    WholeBody whole{body.mass(0, 0), body.mass(2, 2), body.size,
                    scene.reference.centroids[e] + Point{q[e][0], q[e][1]}};
    whole.resultant = forces[e].head<3>();
    whole.gross = whole.resultant.head<2>().norm();
    seen(whole);
  }
}

double BlockBodies::fastest_centre(const UnknownsTable& v) const {
  double fastest = 0;
  for (const Unknowns& of : v)
    if (of.size() > 0) fastest = std::max(fastest, of.head<2>().norm());
  return fastest;
}

double BlockBodies::fastest_point(const UnknownsTable& v) const {
  double top = 0;
  for (ElementIndex e : indices(v)) {
    const Eigen::Index n = v[e].size();
    if (n == 0) continue;
    double speed = std::hypot(v[e][0], v[e][1]);
    for (Eigen::Index i = 2; i < n; ++i) speed += bodies_[e].size * std::abs(v[e][i]);
    top = std::max(top, speed);
  }
  return top;
}

double BlockBodies::greatest_change(const UnknownsTable& a, const UnknownsTable& b) const {
  double change = 0;
  for (ElementIndex e : indices(a))
    if (a[e].size() > 0) change = worse(change, greatest((a[e] - b[e]).cwiseAbs(), bodies_[e].size));
  return change;
}

double BlockBodies::step_error(const BodiesMotion& before, const BodiesMotion& after, const StepRule& rule,
                               double dt) const {
  double largest = 0;
  for (ElementIndex e : indices(before.q)) {
    if (before.q[e].size() == 0) continue;
    const Unknowns change = after.a[e] - before.a[e];
    const Unknowns mean = rule.carries_acceleration() ? Unknowns(before.a[e] + change / 2) : after.a[e];
    const Unknowns jump = after.v[e] - before.v[e] - dt * mean;
    const Unknowns error =
        dt * dt * (rule.error_of_change * change.cwiseAbs() + rule.error_of_acceleration * mean.cwiseAbs()) +
        dt * jump.cwiseAbs();
    largest = worse(largest, error.head<2>().norm() / bodies_[e].size);
    largest = worse(largest, error.tail(error.size() - 2).maxCoeff<Eigen::PropagateNaN>());
  }
  return largest;
}

}  // namespace keyblock
