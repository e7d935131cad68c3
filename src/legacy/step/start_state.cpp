// Takes velocities and stress from the materials; quirks decide which of their numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/start_state.hpp"

#include <algorithm>
#include <cmath>

#include "legacy/step/hanging.hpp"
#include "material/material_stress.hpp"

namespace keyblock {
namespace {

// Returns the values in the material slots 8 to 10 of the Berkeley engine: stress gradient and start velocity
// (legacy-rules 7.5, 16.1). The dialect of the file decides which values those are.
Velocity slots_8_to_10(const BlockMaterial& material, const BerkeleyQuirks& quirks) {
  if (quirks.ddaml_slots) return material.initial_velocity;
  return {material.stress_gradient.xx, material.stress_gradient.yy, material.stress_gradient.xy};
}

// Returns the values in slots 11 to 13.
Velocity slots_11_to_13(const BlockMaterial& material, const BerkeleyQuirks& quirks) {
  if (!quirks.ddaml_slots) return material.initial_velocity;
  return {material.initial_strain[0], material.initial_strain[1], material.initial_strain[2]};
}

Velocity start_velocity(const BlockMaterial& material, const BerkeleyQuirks& quirks) {
  return quirks.start_velocity_slots ? slots_8_to_10(material, quirks) : material.initial_velocity;
}

Stress stress_gradient(const BlockMaterial& material, const BerkeleyQuirks& quirks) {
  if (!quirks.start_velocity_slots) return material.stress_gradient;
  const Velocity slots = slots_8_to_10(material, quirks);
  return {slots.x, slots.y, slots.rotation};
}

}  // namespace

State start_state(const Model& model, const Settings& settings) {
  State state;
  state.vertices.assign(model.start_vertices.begin(), model.start_vertices.end());
  state.elements.reserve(model.elements.size());
  for (ElementIndex e : indices(model.elements)) {
    const Element& element = model.elements[e];
    const BlockMaterial& material = model.material_of(element);
    const auto [centroid, moments] = place(model, state.vertices, e, settings);
    const Velocity v = start_velocity(material, settings.quirks);
    Unknowns velocity = Unknowns::Zero(element.basis->unknown_count());
    velocity.head<3>() << v.x, v.y, v.rotation;
    state.elements.push_back(
        {centroid, moments, velocity, Unknowns::Zero(element.basis->unknown_count()),
         start_stress(material, stress_gradient(material, settings.quirks), centroid.y, settings.plane), 0});
  }
  state.nodes = start_nodes(model, state.elements);
  hang_velocities(model, state);
  for (const CarriedPoint& p : model.fixed_points) state.fixed_points.push_back({p.start, {}});
  for (const CarriedPoint& p : model.loading_points) state.loading_points.push_back({p.start, {}});
  for (const CarriedPoint& p : model.measured_points) state.measured_points.push_back({p.start, {}});
  for (const Bolt& bolt : model.bolts) state.bolts.push_back({bolt.first.start, bolt.second.start, bolt.pretension});
  return state;
}

double greatest_start_speed(const Model& model, const Settings& settings) {
  const BerkeleyQuirks& quirks = settings.quirks;
  double speed = 0;
  for (const BlockMaterial& material : model.block_materials) {
    const Velocity v = quirks.start_velocity_slots ? slots_11_to_13(material, quirks) : material.initial_velocity;
    speed = std::max({speed, std::abs(v.x), std::abs(v.y), std::abs(v.rotation)});
  }
  return speed;
}

}  // namespace keyblock
