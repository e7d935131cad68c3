// Computes scene, start, loads and scales of Dynamics::standard.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/standard_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "contact/rows/point_motion.hpp"
#include "geometry/polygon.hpp"
#include "model/body_load.hpp"
#include "model/scene/scene.hpp"
#include "model/setup/choose_basis.hpp"
#include "step/groups/make_groups.hpp"
#include "step/scene/enforcement.hpp"

namespace keyblock {
namespace {

constexpr double kSlowSteps = 3;
// A bend so near the end of a step, relative to its length, lies there: times of steps are sums.
constexpr double kRoundOffOfTimes = 1e-9;
// Speeds below this fraction of the fastest block are round-off of earlier solves, not an approach.
constexpr double kSpeedRoundOff = 1e-10;

Point mass_centre_of(const StandardScene& scene) {
  double mass = 0;
  Point sum;
  BodiesMotion start;
  for (const auto& group : scene.groups) group->put_start(scene.parts(), start);
  start.q.set_zero();
  for (const auto& group : scene.groups)
    group->look_at_bodies(scene.parts(), start.q, start.q, [&](const WholeBody& body) {
      mass += body.mass;
      sum = sum + body.mass * body.centre;
    });
  return mass > 0 ? (1 / mass) * sum : Point{};
}

// Returns twice the area over the perimeter: half the width of a long block, half the side of a square.
double half_width_of(const ConvexPieces& pieces, const std::vector<Point>& vertices) {
  double around = 0, twice_area = 0;
  for (const ConvexPiece& piece : pieces) {
    std::vector<Point> loop;
    for (const VertexIndex v : piece.corners) loop.push_back(vertices[static_cast<std::size_t>(v.value)]);
    twice_area += 2 * area(loop);
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (!piece.is_inner[i]) around += distance(loop[i], loop[(i + 1) % loop.size()]);
  }
  return around > 0 ? twice_area / around : 0;
}

// A pressure turns and grows with its edge, which stays straight.
void add_edge_loads(const StandardScene& scene, const UnknownsTable& q, const PointMotions& points, double time,
                    UnknownsTable& loads) {
  for (const EdgeLoad& load : scene.model.edge_loads) {
    if (loads[load.element].size() == 0) continue;
    const EdgeForces now = load.at(time);
    Point normal;  // outward, times the present length
    if (now.pushes != std::array<double, 2>{}) {
      const auto place = [&](Point start) { return point_at(scene.model, scene.reference, q, load.element, start); };
      const Point along = place(load.edge.end) - place(load.edge.start);
      normal = {along.y, -along.x};
    }
    const std::array<Point, 2> ends{load.edge.start, load.edge.end};
    for (std::size_t k = 0; k < 2; ++k)
      add_force(points.of_point(load.element, ends[k]), load.element,
                now.factor * (now.forces[k] - now.pushes[k] * normal), loads);
  }
}

// Bolts without stiffness pull with their pretension along the line of their ends.
void add_constant_bolts(const StandardScene& scene, const UnknownsTable& q, UnknownsTable& loads) {
  const auto has_force = [](const Bolt& bolt) { return bolt.constant_force() != 0; };
  if (std::ranges::none_of(scene.model.bolts, has_force)) return;
  const ContactRows rows = bolt_rows(scene.model, scene.reference, q);
  for (std::size_t i = 0; i < scene.model.bolts.size(); ++i) {
    const double force = scene.model.bolts[i].constant_force();
    rows[2 * i].add_to(loads, -force);
  }
}

}  // namespace

StandardScene standard_scene(Model model, Settings settings, std::shared_ptr<const Groundwork> groundwork) {
  StandardScene scene;
  scene.model = std::move(model);
  scene.settings = with_enforcement_decided(std::move(settings), scene.model);
  scene.reference = reference_of(scene.model, scene.settings);
  MadeGroups made = groups_of(scene.model, scene.settings, scene.reference, groundwork);
  scene.groups = std::move(made.all);
  scene.blocks = std::move(made.blocks);
  scene.groundwork = std::move(made.groundwork);
  scene.pieces.reserve(scene.model.elements.size());
  scene.with_faces.reserve(scene.model.elements.size());
  for (ElementIndex e : indices(scene.model.elements)) scene.pieces.push_back(convex_pieces(scene.model, e));
  for (ElementIndex e : indices(scene.pieces))
    if (!scene.pieces[e].empty()) scene.with_faces.push_back(e);
  scene.rounding.reserve(scene.pieces.size());
  // Springs that stop impacts would push out the whole overlap with which rounded corners pass each other.
  const StandardChoices& choices = scene.settings.standard;
  const double rounding = choices.impact == ImpactLaw::springs ? 0 : choices.corner_rounding;
  for (const ConvexPieces& pieces : scene.pieces)
    scene.rounding.push_back(rounding * half_width_of(pieces, scene.model.start_vertices));
  scene.held = held_pairs(scene.model);
  scene.load_bends = bends_of_loads(scene.model, scene.settings);
  scene.mass_centre = mass_centre_of(scene);
  return scene;
}

StandardScene standard_scene(Scene scene) {
  return standard_scene(std::move(scene.model), std::move(scene.settings), std::move(scene.groundwork));
}

std::string unsupported(const StandardScene& scene) {
  for (ElementIndex e : indices(scene.pieces)) {
    const bool takes_holes = scene.groups.of(e).takes_holes();
    if (!takes_holes && scene.model.elements[e].loop_sizes.size() > 1)
      return fmt::format("expected elements without holes, found one in element {}: a finer mesh has none",
                         scene.model.number_of(e));
    if (scene.pieces[e].empty() && takes_holes)
      return fmt::format(
          "expected holes inside their block, clockwise, that meet neither each other nor its outline, found others in "
          "block {}",
          scene.model.number_of(e));
    if (std::ranges::any_of(scene.pieces[e], [](const ConvexPiece& piece) { return piece.corners.size() < 3; }))
      return fmt::format("expected blocks with three corners at least, found block {} without area",
                         scene.model.number_of(e));
  }
  return {};
}

Motion start_motion(const StandardScene& scene) {
  Motion motion;
  for (const auto& group : scene.groups) group->put_start(scene.parts(), motion);
  motion.constraints = constraint_start(scene.model.bolts, scene.held.size());
  return motion;
}

void add_centrifugal_force(const StandardScene& scene, const UnknownsTable& v, UnknownsTable& loads) {
  for (ElementIndex e : indices(loads)) {
    const Body& body = scene.bodies()[e];
    const Eigen::Index strains = body.strain_count();
    if (loads[e].size() == 0 || strains == 0) continue;
    Unknowns stretch = Unknowns::Zero(loads[e].size());
    stretch.segment<2>(kRigidUnknowns).setOnes();
    loads[e].tail(strains) += v[e][2] * v[e][2] * (body.mass * stretch).tail(strains);
  }
}

UnknownsTable loads_at(const StandardScene& scene, const UnknownsTable& q, double time) {
  UnknownsTable loads;
  for (const auto& group : scene.groups) group->put_own_loads(q, time, loads);
  if (has_body_acceleration(scene.settings)) {
    const Eigen::Vector2d acceleration = body_acceleration_at(scene.settings, time);
    for (const auto& group : scene.groups) group->add_inertia({acceleration.x(), acceleration.y()}, loads);
  }
  const PointMotions points(scene.model, scene.reference, q);
  for (const CarriedPoint& point : scene.model.loading_points)
    add_force(points.of_point(point.element, point.start), point.element, point.curve.at(time), loads);
  add_edge_loads(scene, q, points, time, loads);
  add_constant_bolts(scene, q, loads);
  loads *= scene.load_share;
  for (const FacePull& pull : scene.pulls)
    add_force(points.of_point(pull.element, pull.start), pull.element, pull.force, loads);
  if (!scene.unloaded.empty())
    for (const auto& group : scene.groups) group->unload(scene.unloaded, loads);
  return loads;
}

// Loads are linear between bends, so that their mean over a part is the value at its middle.
UnknownsTable mean_loads(const StandardScene& scene, const UnknownsTable& q, double middle, double length) {
  const double round_off = kRoundOffOfTimes * length;
  const double end = middle + length / 2;
  double from = middle - length / 2;
  const auto first = std::ranges::upper_bound(scene.load_bends, from + round_off);
  const auto last = std::ranges::lower_bound(scene.load_bends, end - round_off);
  if (first >= last) return loads_at(scene, q, middle);
  UnknownsTable mean = loads_at(scene, q, from + (*first - from) / 2);
  mean *= (*first - from) / length;
  for (auto bend = first; bend != last; ++bend) {
    from = *bend;
    const double to = std::next(bend) == last ? end : *std::next(bend);
    mean = plus(mean, (to - from) / length, loads_at(scene, q, from + (to - from) / 2));
  }
  return mean;
}

Flexibility mass_flexibility(const StandardScene& scene) {
  Flexibility flexibility;
  for (const auto& group : scene.groups) group->put_mass_inverse(flexibility);
  return flexibility;
}

UnknownsTable momentum(const StandardScene& scene, const UnknownsTable& v) {
  UnknownsTable momentum;
  for (const auto& group : scene.groups) group->put_momentum(v, momentum);
  return momentum;
}

double largest_momentum(const StandardScene& scene, const UnknownsTable& v) {
  double largest = 0;
  for (const auto& group : scene.groups) largest = std::max(largest, group->largest_momentum(v));
  return largest;
}

double StandardScene::size() const {
  double largest = 0;
  for (const auto& group : groups) largest = std::max(largest, group->size());
  return largest;
}

bool StandardScene::is_linear() const {
  return std::ranges::all_of(groups, [](const BodyGroups::Group& group) { return group->is_linear(); });
}

Scales scales_of(const StandardScene& scene, const UnknownsTable& loads, const UnknownsTable& q,
                 const UnknownsTable& v) {
  Scales scales;
  for (const auto& group : scene.groups) group->add_to(scales, loads, q, v);
  return scales;
}

Scales scales_at(const StandardScene& scene, const BodiesMotion& motion, double time) {
  return scales_of(scene, loads_at(scene, motion.q, time), motion.q, motion.v);
}

bool may_yield(const StandardScene& scene) {
  return std::ranges::any_of(scene.groups, [](const BodyGroups::Group& group) { return group->may_yield(); });
}

double slow_speed(const StandardScene& scene, const Scales& scales, const UnknownsTable& v, double dt) {
  double fastest = 0;
  for (const auto& group : scene.groups) fastest = std::max(fastest, group->fastest_centre(v));
  return std::max(kSlowSteps * scales.acceleration * dt, kSpeedRoundOff * fastest);
}

}  // namespace keyblock
