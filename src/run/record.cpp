// Copies reported values out of the state.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/record.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "fracture/crack_faces.hpp"
#include "fracture/growth.hpp"
#include "model/continuum.hpp"
#include "model/shared_covers.hpp"
#include "run/growth/solution_of.hpp"

namespace keyblock {
namespace {

std::vector<std::vector<Point>> loops_of(const Element& element, const State& state) {
  std::vector<std::vector<Point>> loops;
  VertexIndex v = element.first_vertex;
  for (int size : element.loop_sizes) {
    std::vector<Point>& loop = loops.emplace_back();
    loop.reserve(static_cast<std::size_t>(size));
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

std::vector<PointFrame> points_of(const Model& model, const std::vector<CarriedPoint>& points,
                                  const std::vector<PointState>& states, const State& state) {
  std::vector<PointFrame> frames;
  for (std::size_t i = 0; i < points.size(); ++i)
    frames.push_back({states[i].position, states[i].displacement,
                      model.identities.of_element(points[i].element.value).number, -1,
                      state.elements[points[i].element].stress});
  return frames;
}

constexpr double kNotThere = std::numeric_limits<double>::quiet_NaN();

/// Stores a value at the index `number`; entries skipped before it are `missing`.
template <class T>
void put(std::vector<T>& values, int number, T value, const T& missing) {
  const auto place = static_cast<std::size_t>(number);
  if (place >= values.size()) values.resize(place + 1, missing);
  values[place] = std::move(value);
}

const PointFrame kMissingPoint{{kNotThere, kNotThere}, {kNotThere, kNotThere}, 0, -1, {}};

// Fraction of the way from a corner to the middle of its element: near-tip functions have no finite stress at the tip.
constexpr double kBesideTip = 1e-3;

Stress stress_beside_tip(const Stepper& stepper, ElementIndex e, Point at, Point middle) {
  const Stress stress = stepper.stress_at(e, at);
  const double sum = stress.xx + stress.yy + stress.xy + stress.zz;
  return std::isfinite(sum) ? stress : stepper.stress_at(e, at + kBesideTip * (middle - at));
}

}  // namespace

Frame frame_of(const Model& model, const State& state, const StartPlaces& start, const Settings& settings) {
  Frame frame{state.step, state.time, {}, {}, {}, {}, {}, outlines_of(model, state)};
  frame.elements.reserve(model.elements.size());
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
         density * (first.xx + first.yy),
         model.identities.of_element(e.value).number,
         model.identities.of_element(e.value).origin});
  }
  frame.fixed_points = points_of(model, model.fixed_points, state.fixed_points, state);
  frame.loading_points = points_of(model, model.loading_points, state.loading_points, state);
  frame.measured_points = points_of(model, model.measured_points, state.measured_points, state);
  for (std::size_t i = 0; i < frame.measured_points.size(); ++i)
    frame.measured_points[i].number = model.identities.of_measured_point(i);
  for (std::size_t i = 0; i < state.bolts.size(); ++i) {
    const BoltState& bolt = state.bolts[i];
    frame.bolts.push_back(
        {bolt.first, bolt.second, bolt.force, bolt.is_broken, model.identities.of_bolt(i), model.bolts[i].name});
  }
  return frame;
}

void put_least_area(StepReport& report, const Model& model, const State& state, const StartPlaces& start) {
  report.area_share = std::numeric_limits<double>::max();
  for (ElementIndex e : indices(model.elements)) {
    const double share = state.elements[e].moments.area / start.elements[e].moments.area;
    if (share >= report.area_share) continue;  // NaN stays
    report.area_share = share;
    report.crushed_element = model.identities.of_element(e.value).number;
    if (std::isnan(share)) return;
  }
}

HistoryRow history_row(const Model& model, const State& state, const StartPlaces& start, bool of_measured_points) {
  HistoryRow row{state.step, state.time, {}, {}};
  const Identities& names = model.identities;
  for (std::size_t i = 0; i < state.bolts.size(); ++i)
    put(row.bolt_forces, names.of_bolt(i), state.bolts[i].force, kNotThere);
  const std::vector<PointFrame> measured = points_of(model, model.measured_points, state.measured_points, state);
  for (std::size_t i = 0; i < measured.size(); ++i)
    put(row.points, names.of_measured_point(i), measured[i], kMissingPoint);
  if (of_measured_points) return row;
  for (ElementIndex e : indices(model.elements)) {
    const Point centroid = state.elements[e].centroid;
    const int number = names.of_element(e.value).number;
    put(row.points, number, {centroid, centroid - start.elements[e].centroid, number, -1, state.elements[e].stress},
        kMissingPoint);
  }
  return row;
}

std::vector<Point> reactions_of(const Stepper& stepper) {
  std::vector<Point> reactions;
  if (const std::optional<ForceBalance> forces = stepper.forces())
    for (const Resultant& support : forces->supports) reactions.push_back(support.force);
  return reactions;
}

void put_point_stress(Frame& frame, const Model& model, const Stepper& stepper) {
  for (std::size_t i = 0; i < model.measured_points.size(); ++i)
    frame.measured_points[i].stress =
        stepper.stress_at(model.measured_points[i].element, model.measured_points[i].start);
}

void put_point_stress(HistoryRow& row, const Model& model, const Stepper& stepper) {
  for (std::size_t i = 0; i < model.measured_points.size(); ++i)
    row.points[static_cast<std::size_t>(model.identities.of_measured_point(i))].stress =
        stepper.stress_at(model.measured_points[i].element, model.measured_points[i].start);
}

void put_plastic(Frame& frame, const Stepper& stepper) {
  frame.plastic = stepper.plastic_totals();
  if (!frame.plastic) return;
  const Model& model = stepper.model();
  for (const ElementIndex e : indices(model.elements))
    frame.elements[static_cast<std::size_t>(e.value)].plastic =
        stepper.plastic_at(e, stepper.unloaded().elements[e].centroid);
  for (std::size_t i = 0; i < model.measured_points.size(); ++i)
    frame.measured_points[i].plastic =
        stepper.plastic_at(model.measured_points[i].element, model.measured_points[i].start);
}

void put_plastic(HistoryRow& row, const Stepper& stepper, bool of_measured_points) {
  row.driven = stepper.driven();
  row.load_share = stepper.load_share();
  row.plastic = stepper.plastic_totals();
  if (!row.plastic || !of_measured_points) return;
  const Model& model = stepper.model();
  for (std::size_t i = 0; i < model.measured_points.size(); ++i)
    row.points[static_cast<std::size_t>(model.identities.of_measured_point(i))].plastic =
        stepper.plastic_at(model.measured_points[i].element, model.measured_points[i].start);
}

std::vector<TipState> tips_of(const Stepper& stepper, TipsOf which) {
  const Model& model = stepper.model();
  std::vector<TipState> tips = stepper.tips();
  if (!tips.empty() || !model.continuum || model.continuum->manifold.tips.empty()) return tips;
  if (which == TipsOf::cracks && model.continuum->cracks.empty()) return tips;
  const std::optional<CoverSolution> solution = solution_of(stepper);
  if (!solution) return tips;
  tips = followed_tips(model.continuum->manifold, model.continuum->cracks);
  for (TipState& tip : tips) put_factors(tip, *solution, GrowthCriterion::hoop_stress);
  return tips;
}

namespace {

// Returns true if stress does not vary within any element, now or later in the run.
bool is_uniform(const Model& model) {
  if (!model.continuum) return model.nodes.empty();
  const Continuum& bodies = *model.continuum;
  const auto varies = [](const BlockMaterial& rock) { return rock.is_nonlinear() || rock.stress_gradient != Stress{}; };
  return bodies.functions == CoverFunctions::constant && !bodies.initial_stress && bodies.manifold.tips.empty() &&
         bodies.cracks.empty() && std::ranges::none_of(bodies.materials, varies);
}

}  // namespace

FieldFrame field_of(const Model& model, const Stepper& stepper) {
  const State& state = stepper.state();
  const StartPlaces& start = stepper.unloaded();
  FieldFrame field{state.step, state.time, {}, stepper.plastic_totals(), model.nodes.empty(), {}, is_uniform(model)};
  const auto corner = [&](ElementIndex e, Point at, Point now) {
    return FieldCorner{at, now - at, stress_beside_tip(stepper, e, at, start.elements[e].centroid),
                       field.plastic ? stepper.plastic_at(e, at) : std::nullopt};
  };
  const std::vector<int> bodies = body_numbers(model);
  field.elements.reserve(model.elements.size());
  for (ElementIndex e : indices(model.elements)) {
    const Element& element = model.elements[e];
    const Point centroid = start.elements[e].centroid;
    FieldElement& out = field.elements.emplace_back();
    out.body = bodies[static_cast<std::size_t>(e.value)];
    out.material = element.material;
    out.middle = corner(e, centroid, state.elements[e].centroid);
    VertexIndex v = element.first_vertex;
    for (const int size : element.loop_sizes) {
      auto& loop = out.loops.emplace_back();
      loop.reserve(static_cast<std::size_t>(size));
      for (int i = 0; i < size; ++i, ++v.value) {
        const Point at = start.vertices[v], now = state.vertices[v];
        loop.push_back(field.is_uniform ? FieldCorner{at, now - at, out.middle.stress} : corner(e, at, now));
      }
    }
  }
  if (model.continuum && !model.continuum->cracks.empty())
    field.cracks = with_faces(model.continuum->cracks, field.elements);
  return field;
}

Frame frame_now(const Stepper& stepper) {
  Frame frame = frame_of(stepper.model(), stepper.state(), stepper.unloaded(), stepper.settings());
  put_point_stress(frame, stepper.model(), stepper);
  frame.reactions = reactions_of(stepper);
  put_plastic(frame, stepper);
  frame.tips = tips_of(stepper, TipsOf::cracks_and_joints);
  frame.load_factor = stepper.load_factor();
  return frame;
}

}  // namespace keyblock
