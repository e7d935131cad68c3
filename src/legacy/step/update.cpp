// Applies the increments of an accepted step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/update.hpp"

#include "base/decimals.hpp"
#include "base/loop.hpp"
#include "legacy/step/hanging.hpp"
#include "legacy/step/motion.hpp"
#include "material/material_stress.hpp"

namespace keyblock {
namespace {

class Mover {
 public:
  Mover(const Model& model, const State& before, const Increments& increments, Rotation rotation)
      : model_(model), before_(before), increments_(increments), rotation_(rotation) {}

  Point operator()(ElementIndex e, Point p) const {
    const Point offset = p - before_.elements[e].centroid;
    return displacement(*model_.elements[e].basis, increments_[e], offset, rotation_);
  }

 private:
  const Model& model_;
  const State& before_;
  const Increments& increments_;
  Rotation rotation_;
};

void move(std::vector<PointState>& states, const std::vector<CarriedPoint>& points, const Mover& mover) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point step = mover(points[i].element, states[i].position);
    states[i].position = states[i].position + step;
    states[i].displacement = states[i].displacement + step;
  }
}

void move(std::vector<BoltState>& states, const std::vector<Bolt>& bolts, const Mover& mover) {
  for (std::size_t i = 0; i < bolts.size(); ++i) {
    BoltState& now = states[i];
    now.first = now.first + mover(bolts[i].first.element, now.first);
    now.second = now.second + mover(bolts[i].second.element, now.second);
    now.force = bolts[i].force_at(distance(now.first, now.second));
  }
}

std::vector<double> carry_overs_of_nodes(const Model& model, const Settings& settings) {
  std::vector<double> carry_overs(model.nodes.size(), 0);
  if (carry_overs.empty()) return carry_overs;
  for (const Element& element : model.elements) {
    if (!element.is_on_covers()) continue;
    for (const int node : element.covers)
      carry_overs[static_cast<std::size_t>(node)] = settings.velocity_carry_over.of(element.material);
  }
  return carry_overs;
}

}  // namespace

State update(const Model& model, State state, const Settings& settings, const Increments& increments, double dt,
             const std::vector<Point>& node_steps) {
  const State before = state;
  const Mover mover(model, before, increments, settings.rotation);
  for_each_entry(model.vertices.size(), [&](std::size_t i) {
    const VertexIndex v{static_cast<int>(i)};
    state.vertices[v] = before.vertices[v] + mover(model.vertices[v].element, before.vertices[v]);
  });
  move(state.fixed_points, model.fixed_points, mover);
  move(state.loading_points, model.loading_points, mover);
  move(state.measured_points, model.measured_points, mover);
  move(state.bolts, model.bolts, mover);
  for (std::size_t i = 0; i < node_steps.size(); ++i) {
    state.nodes[i].position = before.nodes[i].position + node_steps[i];
    state.nodes[i].last_step = node_steps[i];
  }
  for_each_entry(model.elements.size(), [&](std::size_t i) {
    const ElementIndex e{static_cast<int>(i)};
    const Element& element = model.elements[e];
    const BlockMaterial& material = model.material_of(element);
    ElementState& now = state.elements[e];
    now.stress = with_across(
        in_plane(now.stress) + modulus_of(material, settings.plane) * (element.basis->strain() * increments[e]),
        now.stress, share_across(material, settings.plane));
    now.last_step = increments[e];
    if (element.basis->rotation_unknown >= 0) now.rotation += increments[e][element.basis->rotation_unknown];
    const Placement placement = place(model, state.vertices, e, settings);
    now.centroid = placement.centroid;
    now.moments = placement.moments;
  });
  if (!settings.quirks.velocity_from_coming_step)
    state = with_velocity_of_last_step(model, std::move(state), settings, dt);
  state.time = time_after(state.time, dt);
  state.dt = dt;
  ++state.step;
  return state;
}

State with_velocity_of_last_step(const Model& model, State state, const Settings& settings, double dt) {
  for_each_index(model.elements, [&](ElementIndex e) {
    ElementState& now = state.elements[e];
    const double carry_over = settings.velocity_carry_over.of(model.elements[e].material);
    now.velocity = 2 / dt * now.last_step - carry_over * now.velocity;
  });
  const std::vector<double> carry_overs = carry_overs_of_nodes(model, settings);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    NodeState& node = state.nodes[i];
    node.velocity = 2 / dt * node.last_step - carry_overs[i] * node.velocity;
  }
  hang_velocities(model, state);
  return state;
}

}  // namespace keyblock
