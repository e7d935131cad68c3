// Scene, start, loads and scales of Dynamics::standard.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/standard_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/rows/point_motion.hpp"
#include "model/body_load.hpp"
#include "model/setup/choose_basis.hpp"
#include "step/scene/enforcement.hpp"
#include "step/scene/step_constraints.hpp"

namespace keyblock {
namespace {

constexpr double kSlowSteps = 3;
// Speeds below this share of the fastest block are round-off of the solves before, not an approach.
constexpr double kSpeedRoundOff = 1e-10;

Point mass_centre_of(const StandardScene& scene) {
  double mass = 0;
  Point sum;
  for (ElementIndex e : indices(scene.bodies)) {
    if (scene.bodies[e].mass.rows() == 0) continue;
    mass += scene.bodies[e].mass(0, 0);
    sum = sum + scene.bodies[e].mass(0, 0) * scene.reference.centroids[e];
  }
  if (scene.covers) {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(scene.covers->weight().size());
    for (const WholeBody& body : scene.covers->whole(none, none)) {
      mass += body.mass;
      sum = sum + body.mass * body.centre;
    }
  }
  return mass > 0 ? (1 / mass) * sum : Point{};
}

// Bolts without stiffness pull with their pretension along the line of their ends.
void add_constant_bolts(const StandardScene& scene, const UnknownsTable& q, UnknownsTable& loads) {
  const auto has_force = [](const Bolt& bolt) { return bolt.constant_force() != 0; };
  if (std::ranges::none_of(scene.model.bolts, has_force)) return;
  const ContactRows rows = bolt_rows(scene.model, scene.reference, q);
  for (std::size_t i = 0; i < scene.model.bolts.size(); ++i) {
    const double force = scene.model.bolts[i].constant_force();
    loads[rows[2 * i].vertex_element] -= force * rows[2 * i].of_vertex.transpose();
    loads[rows[2 * i].edge_element] -= force * rows[2 * i].of_edge.transpose();
    rows[2 * i].add_covers(-force, loads.covers);
  }
}

}  // namespace

StandardScene standard_scene(Model model, Settings settings) {
  StandardScene scene;
  scene.model = std::move(model);
  scene.settings = with_enforcement_decided(std::move(settings), scene.model);
  scene.reference = reference_of(scene.model, scene.settings);
  scene.bodies = bodies_of(scene.model, scene.reference, scene.settings);
  scene.pieces.reserve(scene.model.elements.size());
  scene.with_faces.reserve(scene.model.elements.size());
  for (ElementIndex e : indices(scene.model.elements)) scene.pieces.push_back(convex_pieces(scene.model, e));
  for (ElementIndex e : indices(scene.pieces))
    if (!scene.pieces[e].empty()) scene.with_faces.push_back(e);
  if (std::ranges::any_of(scene.model.elements, &Element::is_on_covers)) {
    scene.covers = std::make_shared<CoverScene>(scene.model, scene.settings);
    scene.reference.covers = scene.covers->kinematics();
    for (ElementIndex e : indices(scene.bodies))
      if (scene.model.elements[e].is_on_covers()) scene.bodies[e].size = scene.covers->body_at_start(e).size;
  }
  scene.held = held_points(scene.model);
  scene.mass_centre = mass_centre_of(scene);
  return scene;
}

std::string unsupported(const StandardScene& scene) {
  for (ElementIndex e : indices(scene.pieces)) {
    const Element& element = scene.model.elements[e];
    if (element.is_on_covers() && element.loop_sizes.size() > 1)
      return fmt::format("expected elements without holes, found one in element {}: a finer mesh has none",
                         e.value + 1);
    if (scene.pieces[e].empty() && !element.is_on_covers())
      return fmt::format(
          "expected holes inside their block, clockwise, that meet neither each other nor its outline, found others in "
          "block {}",
          e.value + 1);
    if (std::ranges::any_of(scene.pieces[e], [](const ConvexPiece& piece) { return piece.corners.size() < 3; }))
      return fmt::format("expected blocks with three corners at least, found block {} without area", e.value + 1);
  }
  return {};
}

Motion start_motion(const StandardScene& scene) {
  Motion motion;
  for (UnknownsTable* table : {&motion.q, &motion.v, &motion.a}) table->reserve(scene.model.elements.size());
  for (const Element& element : scene.model.elements) {
    const int count = element.basis->unknown_count();
    motion.q.push_back(Unknowns::Zero(count));
    Unknowns v = Unknowns::Zero(count);
    const Velocity& given = scene.model.material_of(element).initial_velocity;
    if (count > 0) v.head<3>() << given.x, given.y, given.rotation;
    motion.v.push_back(v);
    motion.a.push_back(Unknowns::Zero(count));
  }
  if (scene.covers) {
    motion.v.covers = scene.covers->start_velocity();
    motion.q.covers = motion.a.covers = Eigen::VectorXd::Zero(motion.v.covers.size());
  }
  motion.constraints = constraint_start(scene);
  return motion;
}

void add_centrifugal_force(const StandardScene& scene, const UnknownsTable& v, UnknownsTable& loads) {
  for (ElementIndex e : indices(loads)) {
    const Body& body = scene.bodies[e];
    const Eigen::Index strains = body.strain_count();
    if (loads[e].size() == 0 || strains == 0) continue;
    Unknowns stretch = Unknowns::Zero(loads[e].size());
    stretch.segment<2>(kRigidUnknowns).setOnes();
    loads[e].tail(strains) += v[e][2] * v[e][2] * (body.mass * stretch).tail(strains);
  }
}

UnknownsTable loads_at(const StandardScene& scene, const UnknownsTable& q, double time) {
  UnknownsTable loads;
  loads.reserve(scene.bodies.size());
  for (const Body& body : scene.bodies) loads.push_back(body.weight);
  if (scene.covers) loads.covers = scene.covers->weight();
  if (has_body_acceleration(scene.settings)) {
    const Eigen::Vector2d acceleration = body_acceleration_at(scene.settings, time);
    for (ElementIndex e : indices(loads))
      if (loads[e].size() > 0) loads[e].head<2>() += scene.bodies[e].mass(0, 0) * acceleration;
    if (scene.covers) loads.covers += scene.covers->inertia_of({acceleration.x(), acceleration.y()});
  }
  const PointMotions points(scene.model, scene.reference, q);
  for (const CarriedPoint& point : scene.model.loading_points) {
    const Point force = point.curve.at(time);
    const PointMotion motion = points.of_point(point.element, point.start);
    loads[point.element] += motion.of_block.transpose() * Eigen::Vector2d(force.x, force.y);
    for (const CoverShare& share : motion.of_covers)
      loads.covers.segment<2>(2 * share.function) += share.value * Eigen::Vector2d(force.x, force.y);
  }
  add_constant_bolts(scene, q, loads);
  loads *= scene.load_share;
  return loads;
}

Flexibility mass_flexibility(const StandardScene& scene) {
  return {mass_inverses(scene.bodies), scene.covers ? scene.covers->mass_inverse() : nullptr};
}

Scales scales_of(const StandardScene& scene, const UnknownsTable& loads, const UnknownsTable& q,
                 const UnknownsTable& v) {
  Scales scales;
  const auto add = [&](double mass, double size, double force, double momentum) {
    scales.force = std::max(scales.force, force);
    scales.acceleration = std::max(scales.acceleration, force / mass);
    scales.momentum = std::max(scales.momentum, momentum);
    scales.size = std::max(scales.size, size);
  };
  for (ElementIndex e : indices(loads)) {
    if (loads[e].size() == 0) continue;
    const Body& body = scene.bodies[e];
    const double mass = body.mass(0, 0);
    const double force = std::hypot(loads[e][0], loads[e][1]) + std::abs(loads[e][2]) / body.size;
    add(mass, body.size, force, mass * (v[e].head<2>().norm() + body.size * std::abs(v[e][2])));
  }
  if (!scene.covers) return scales;
  for (const WholeBody& body : scene.covers->whole(q.covers, loads.covers))
    add(body.mass, body.size, body.resultant.head<2>().norm() + std::abs(body.resultant[2]) / body.size, 0);
  scales.force = std::max(scales.force, scene.covers->largest_load(scene.covers->initial_force()));
  for (const WholeBody& body : scene.covers->whole(q.covers, scene.covers->momentum(v.covers)))
    scales.momentum =
        std::max(scales.momentum, body.resultant.head<2>().norm() + std::abs(body.resultant[2]) / body.size);
  return scales;
}

double slow_speed(const Scales& scales, const UnknownsTable& v, double dt) {
  double fastest = CoverScene::top_speed(v.covers);
  for (const Unknowns& of : v)
    if (of.size() > 0) fastest = std::max(fastest, of.head<2>().norm());
  return std::max(kSlowSteps * scales.acceleration * dt, kSpeedRoundOff * fastest);
}

}  // namespace keyblock
