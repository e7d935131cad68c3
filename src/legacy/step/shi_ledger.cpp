// Computes energies and momenta block by block from the state.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/shi_ledger.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "material/material_stress.hpp"
#include "model/body_load.hpp"
#include "terms/mass_matrix.hpp"

namespace keyblock {
namespace {

// Returns ½ A σᵀ D⁻¹ σ; D is isotropic, so that the frame of the stress does not matter.
double strain_energy(const Eigen::Matrix3d& compliance, const ElementState& now) {
  const Eigen::Vector3d stress(now.stress.xx, now.stress.yy, now.stress.xy);
  return now.moments.area / 2 * stress.dot(compliance * stress);
}

// Returns D⁻¹ of every block material.
std::vector<Eigen::Matrix3d> compliances(const Model& model, Plane plane) {
  std::vector<Eigen::Matrix3d> all;
  for (const BlockMaterial& material : model.block_materials) all.emplace_back(modulus_of(material, plane).inverse());
  return all;
}

bool is_driven(const CarriedPoint& point) {
  return std::ranges::any_of(point.curve.values, [](Point value) { return value != Point{}; });
}

double work_of_loads(const Model& model, const State& before, const State& after) {
  double work = 0;
  for (std::size_t i = 0; i < model.loading_points.size(); ++i)
    work += dot(model.loading_points[i].curve.at(after.time),
                after.loading_points[i].displacement - before.loading_points[i].displacement);
  return work;
}

double work_of_driven_points(const Model& model, const Settings& settings, const State& before, const State& after) {
  const double stiffness = settings.fixed_point_factor * settings.contact_penalty;
  double work = 0;
  for (std::size_t i = 0; i < model.fixed_points.size(); ++i) {
    if (!is_driven(model.fixed_points[i])) continue;
    const Point gap = model.fixed_points[i].curve.at(after.time) - after.fixed_points[i].displacement;
    work += stiffness * dot(gap, after.fixed_points[i].displacement - before.fixed_points[i].displacement);
  }
  return work;
}

double work_of_bolts(const Model& model, const State& before, const State& after) {
  double work = 0;
  for (std::size_t i = 0; i < model.bolts.size(); ++i) {
    const BoltState& then = before.bolts[i];
    if (then.first == then.second) continue;
    const Point along = (1 / distance(then.first, then.second)) * (then.second - then.first);
    const double elongation = dot(along, (after.bolts[i].second - after.bolts[i].first) - (then.second - then.first));
    work -= (then.force + model.bolts[i].stiffness * elongation) * elongation;
  }
  return work;
}

double work_of_acceleration(const Model& model, const Settings& settings, const State& before, const State& after) {
  if (!has_body_acceleration(settings)) return 0;
  const Eigen::Vector2d acceleration = body_acceleration_at(settings, after.time);
  double work = 0;
  for (ElementIndex e : indices(model.elements)) {
    const Element& element = model.elements[e];
    const double mass = model.material_of(element).density * before.elements[e].moments.area;
    work += mass * acceleration.dot(Eigen::Vector2d(element.basis->constant * after.elements[e].last_step));
  }
  return work;
}

}  // namespace

double work_of_step(const Model& model, const Settings& settings, const State& before, const State& after) {
  return work_of_loads(model, before, after) + work_of_driven_points(model, settings, before, after) +
         work_of_bolts(model, before, after) + work_of_acceleration(model, settings, before, after);
}

bool does_work(const Model& model, const Settings& settings) {
  return !model.loading_points.empty() || !model.bolts.empty() || has_body_acceleration(settings) ||
         std::ranges::any_of(model.fixed_points, is_driven);
}

LedgerRow stored_row(const Model& model, const Settings& settings, const State& state, const StartPlaces& unloaded) {
  const Point centre = stored_scope(unloaded).centre;
  const std::vector<Eigen::Matrix3d> compliance = compliances(model, settings.plane);
  LedgerRow row;
  row.step = state.step;
  row.time = state.time;
  for (ElementIndex e : indices(model.elements)) {
    const Element& element = model.elements[e];
    const BlockMaterial& material = model.material_of(element);
    const ElementState& now = state.elements[e];
    const Placement& first = unloaded.elements[e];
    const Point moved = now.centroid - first.centroid;
    row.stored.strain += strain_energy(compliance[static_cast<std::size_t>(element.material)], now);
    row.stored.gravity -=
        first.moments.area * weight_per_area(material, settings).dot(Eigen::Vector2d(moved.x, moved.y));
    const Unknowns v = end_velocity(now, state, settings, element.material);
    const Unknowns p = mass_matrix(*element.basis, now.moments, material.density) * v;
    if (p.size() == 0) continue;
    const Point linear{p[0], p[1]};
    const Point arm = now.centroid - centre;
    row.stored.kinetic += v.dot(p) / 2;
    row.momentum += {linear, cross(arm, linear) + p[2]};
    row.momentum_size.linear += length(linear);
    row.momentum_size.angular += length(arm) * length(linear) + std::abs(p[2]);
  }
  return row;
}

LedgerScope stored_scope(const StartPlaces& unloaded) {
  Point sum;
  for (const Placement& element : unloaded.elements) sum = sum + element.centroid;
  LedgerScope scope{false, true, (1 / static_cast<double>(unloaded.elements.size())) * sum};
  scope.has_work = true;
  return scope;
}

}  // namespace keyblock
