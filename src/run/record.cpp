// Copies what is reported out of the state.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/record.hpp"

#include <algorithm>

#include "model/shared_covers.hpp"

namespace keyblock {
namespace {

std::vector<std::vector<Point>> loops_of(const Element& element, const State& state) {
  std::vector<std::vector<Point>> loops;
  VertexIndex v = element.first_vertex;
  for (int size : element.loop_sizes) {
    std::vector<Point>& loop = loops.emplace_back();
    for (int i = 0; i < size; ++i, ++v.value) loop.push_back(state.vertices[v]);
  }
  return loops;
}

std::vector<std::vector<Point>> outlines_of(const Model& model, const State& state) {
  std::vector<std::vector<Point>> outlines;
  if (model.nodes.empty()) return outlines;
  Table<VertexIndex, char> is_done(model.vertices.size(), 0);
  for (VertexIndex first : indices(model.vertices)) {
    if (!model.vertices[first].boundary_next || is_done[first]) continue;
    std::vector<Point>& outline = outlines.emplace_back();
    for (VertexIndex v = first; !is_done[v]; v = model.vertices[v].boundary_next) {
      is_done[v] = 1;
      outline.push_back(state.vertices[v]);
    }
  }
  return outlines;
}

std::vector<PointFrame> points_of(const std::vector<CarriedPoint>& points, const std::vector<PointState>& states,
                                  const State& state) {
  std::vector<PointFrame> frames;
  for (std::size_t i = 0; i < points.size(); ++i)
    frames.push_back({states[i].position, states[i].displacement, points[i].element.value,
                      state.elements[points[i].element].stress});
  return frames;
}

}  // namespace

Frame frame_of(const Model& model, const State& state, const StartPlaces& start, const Settings& settings) {
  Frame frame{state.step, state.time, {}, {}, {}, {}, {}, outlines_of(model, state)};
  for (ElementIndex e : indices(model.elements)) {
    const Element& element = model.elements[e];
    const ElementState& now = state.elements[e];
    const Unknowns rates = end_velocity(now, state, settings, element.material);
    const Eigen::Vector2d velocity = element.basis->constant * rates;  // of the centroid; zero for a fixed basis
    const int spin = element.basis->rotation_unknown;
    const Velocity& carried = now.carried;  // zero for elements with unknowns
    const Point moved = now.centroid - start.elements[e].centroid;
    const Moments& first = start.elements[e].moments;
    const double density = model.material_of(element).density;
    frame.elements.push_back(
        {loops_of(element, state),
         element.material,
         now.centroid,
         moved,
         now.rotation,
         {velocity.x() + carried.x, velocity.y() + carried.y, carried.rotation + (spin < 0 ? 0 : rates[spin])},
         now.stress,
         now.moments.area,
         density * first.area,
         density * (first.xx + first.yy)});
  }
  frame.fixed_points = points_of(model.fixed_points, state.fixed_points, state);
  frame.loading_points = points_of(model.loading_points, state.loading_points, state);
  frame.measured_points = points_of(model.measured_points, state.measured_points, state);
  for (const BoltState& bolt : state.bolts)
    frame.bolts.push_back({bolt.first, bolt.second, bolt.force, bolt.is_broken});
  return frame;
}

HistoryRow history_row(const Model& model, const State& state, const StartPlaces& start) {
  HistoryRow row{state.step, state.time, points_of(model.measured_points, state.measured_points, state), {}};
  for (const BoltState& bolt : state.bolts) row.bolt_forces.push_back(bolt.force);
  if (!row.points.empty()) return row;
  for (ElementIndex e : indices(model.elements)) {
    const Point centroid = state.elements[e].centroid;
    row.points.push_back({centroid, centroid - start.elements[e].centroid, e.value, state.elements[e].stress});
  }
  return row;
}

void put_point_stress(std::vector<PointFrame>& measured, const Model& model, const Stepper& stepper) {
  for (std::size_t i = 0; i < model.measured_points.size(); ++i)
    measured[i].stress = stepper.stress_at(model.measured_points[i].element, model.measured_points[i].start);
}

FieldFrame field_of(const Model& model, const Stepper& stepper) {
  const State& state = stepper.state();
  const StartPlaces& start = stepper.unloaded();
  FieldFrame field{state.step, state.time, {}};
  if (model.nodes.empty()) return field;
  const std::vector<int> bodies = body_numbers(model);
  for (ElementIndex e : indices(model.elements)) {
    const Element& element = model.elements[e];
    const Point centroid = start.elements[e].centroid;
    FieldElement& out = field.elements.emplace_back();
    out.body = bodies[static_cast<std::size_t>(e.value)];
    out.material = element.material;
    out.middle = {centroid, state.elements[e].centroid - centroid, stepper.stress_at(e, centroid)};
    VertexIndex v = element.first_vertex;
    for (const int size : element.loop_sizes) {
      auto& loop = out.loops.emplace_back();
      for (int i = 0; i < size; ++i, ++v.value)
        loop.push_back(
            {start.vertices[v], state.vertices[v] - start.vertices[v], stepper.stress_at(e, start.vertices[v])});
    }
  }
  return field;
}

}  // namespace keyblock
