// Bodies on covers answer to forces as rigid blocks do.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rigid_view.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/point_motion.hpp"
#include "tests/support/cover_scenes.hpp"

namespace keyblock::rigid_view_test {
namespace {

using support::mixed_scene_of;
using support::plain_analysis;
using support::rectangle;
using support::standard_settings;

// A slab of 3 m × 1 m on covers above a held floor that is a block.
StandardScene slab_on_covers() {
  Blocks blocks;
  blocks.blocks = {rectangle({-5, -2}, {5, 0}), rectangle({0, 1}, {3, 2})};
  blocks.fixed_points = {{{-4, -1}, 0, {}}, {{4, -1}, 0, {}}};
  const Analysis analysis = plain_analysis(1e-3, 1);
  const Scene scene = mixed_scene_of(blocks, {1}, analysis, standard_settings(analysis), 2, CoverFunctions::derived);
  return standard_scene(scene.model, scene.settings);
}

VertexIndex first_vertex_on_covers(const StandardScene& scene) {
  for (VertexIndex v : indices(scene.model.vertices))
    if (scene.model.elements[scene.model.vertices[v].element].is_on_covers()) return v;
  return scene.model.vertices.end_index();
}

}  // namespace

// A unit impulse n at a point r from the mass centre of a free body: n (1/m + (r × n)²/I) along itself.
TEST(RigidView, a_free_body_answers_by_its_mass_and_inertia) {
  const StandardScene scene = slab_on_covers();
  const Motion motion = start_motion(scene);
  const RigidView view(scene, motion.q);
  const VertexIndex v = first_vertex_on_covers(scene);
  const ElementIndex e = scene.model.vertices[v].element;
  const Point n{0.6, 0.8};
  const ContactRows of_scene{row_of(e, PointMotions(scene.model, scene.reference, motion.q).of_vertex(v), n)};
  const ContactRows rows = view.rows(of_scene);
  const Eigen::VectorXd unit = Eigen::VectorXd::Ones(1);
  const double rate = rates(of_scene, view.answer(rows, unit))[0];
  const double mass = scene.model.material_of(scene.model.elements[e]).density * 3;
  const Point arm = scene.model.start_vertices[static_cast<std::size_t>(v.value)] - Point{1.5, 1.5};
  const double turn = cross(arm, n);
  EXPECT_NEAR(rate * mass, 1 + turn * turn / ((9 + 1) / 12.0), 1e-10);
  EXPECT_NEAR(ContactMatrix(rows, view.flexibility()).diagonal()[0], rate, 1e-12 * rate);
}

// Opposite impulses n at two points of one body do not move it, but turn it: by ((r₁ − r₂) × n)²/I between them, counted once.
TEST(RigidView, opposite_impulses_on_one_body_turn_it) {
  const StandardScene scene = slab_on_covers();
  const Motion motion = start_motion(scene);
  const RigidView view(scene, motion.q);
  const VertexIndex first = first_vertex_on_covers(scene);
  const VertexIndex last{scene.model.vertices.end_index().value - 1};
  const PointMotions points(scene.model, scene.reference, motion.q);
  const Point n{0.6, 0.8};
  const ContactRows rows = view.rows({row_between(scene.model.vertices[first].element, points.of_vertex(first),
                                                  scene.model.vertices[last].element, points.of_vertex(last), n)});
  const auto start = [&](VertexIndex v) { return scene.model.start_vertices[static_cast<std::size_t>(v.value)]; };
  const double turn = cross(start(first) - start(last), n);
  const double mass = 3 * scene.model.material_of(scene.model.elements[scene.model.vertices[first].element]).density;
  ASSERT_GT(std::abs(turn), 0.1);
  EXPECT_NEAR(ContactMatrix(rows, view.flexibility()).diagonal()[0] * mass, turn * turn / ((9 + 1) / 12.0), 1e-10);
}

}  // namespace keyblock::rigid_view_test
