// Computes corners, centroids and measured points of a static solution, and counts its steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/static_stepper.hpp"

#include <utility>
#include <vector>

#include "base/decimals.hpp"
#include "model/kinematics.hpp"
#include "model/setup/free_pieces.hpp"

namespace keyblock {

void StaticStepper::put_places() {
  const Model& model = scene_.model;
  Table<VertexIndex, Point> start;
  Table<VertexIndex, Point> vertices;
  start.reserve(model.vertices.size());
  vertices.reserve(model.vertices.size());
  for (const VertexIndex v : indices(model.vertices)) {
    start.push_back(model.start_vertices[static_cast<std::size_t>(v.value)]);
    vertices.push_back(place_of(model.vertices[v].element, start[v]));
  }
  state_.elements.clear();
  state_.elements.reserve(model.elements.size());
  for (const ElementIndex e : indices(model.elements)) {
    const Point centroid = place(model, start, e, scene_.settings).centroid;
    const Unknowns none = Unknowns::Zero(model.elements[e].basis->unknown_count());
    state_.elements.push_back({place_of(e, centroid), place(model, vertices, e, scene_.settings).moments, none, none,
                               stress_at(e, centroid), rotation_of(e, centroid)});
  }
  state_.vertices = std::move(vertices);
  state_.measured_points.clear();
  for (const CarriedPoint& point : model.measured_points) {
    const Point now = place_of(point.element, point.start);
    state_.measured_points.push_back({now, now - point.start});
  }
}

void StaticStepper::begin_unloaded() {
  put_places();
  unloaded_ = places_of(state_);
}

void StaticStepper::continue_from(const StaticStepper& before) {
  state_.step = before.state_.step;
  state_.time = before.state_.time;
  state_.dt = before.state_.dt;
}

void StaticStepper::describe_time(Archive& archive) {
  archive.value("step", state_.step);
  archive.value("time", state_.time);
  archive.value("dt", state_.dt);
}

StepFailure StaticStepper::failure(Finding why) const {
  return failed("in_load_step", {{{"step", state_.step + 1}}}, std::move(why));
}

std::optional<StepFailure> StaticStepper::unheld_pieces() const {
  const std::vector<FreePiece> free = free_pieces(continuum());
  if (free.empty()) return std::nullopt;
  const FreePiece& first = free.front();
  Facts facts{{{"body", first.body + 1}}, {{"piece", to_string(first)}}, {}, {{{first.middle.x, first.middle.y}}}};
  if (free.size() > 1) facts.numbers.emplace_back("more", free.size() - 1);
  return failure({"piece_without_support", std::move(facts)});
}

StepReport StaticStepper::end_step(int passes, int redos, double residual) {
  ++state_.step;
  state_.dt = scene_.settings.time_step;
  state_.time = short_decimal(state_.step * state_.dt);
  StepReport report;
  report.step = state_.step;
  report.time = state_.time;
  report.dt = state_.dt;
  report.passes = passes;
  report.redos = redos;
  report.residual = residual;
  return report;
}

}  // namespace keyblock
