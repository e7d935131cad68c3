// One NMM body that closes on itself: a fork whose tines meet, compared with beam theory and with its own mirror image.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/cover_scenes.hpp"

namespace keyblock::self_contact_test {
namespace {

using support::mixed_scene_of;
using support::plain_analysis;
using support::standard_settings;

constexpr double kModulus = 5e9;
constexpr double kLength = 4;    // m, of a tine
constexpr double kHeight = 0.4;  // m
constexpr double kGap = 0.02;    // m, between the tines
constexpr double kHalf = kGap / 2;

// Deflection of the tip of a tine under a force there, with the rotation and shear of a beam on an elastic stem left
// out.
double force_of(double deflection) {
  return 3 * kModulus * (kHeight * kHeight * kHeight / 12) * deflection / (kLength * kLength * kLength);
}

// Stem to the left of x = 0, tines to the right; both tips are pressed towards each other.
Scene fork(double force, Enforcement enforcement) {
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.block_materials[0].unit_weight = 0;
  analysis.block_materials[0].poissons_ratio = 0;
  analysis.gravity = 0;
  analysis.penalty_factor = 100;
  BlockPolygon shape;
  for (const Point p : {Point{-2, -1}, Point{0, -1}, Point{0, -kHalf - kHeight}, Point{kLength, -kHalf - kHeight},
                        Point{kLength, -kHalf}, Point{0, -kHalf}, Point{0, kHalf}, Point{kLength, kHalf},
                        Point{kLength, kHalf + kHeight}, Point{0, kHalf + kHeight}, Point{0, 1}, Point{-2, 1}})
    shape.outer.push_back({p, 0});
  Blocks blocks;
  blocks.blocks = {shape};
  Settings settings = standard_settings(analysis);
  settings.standard.enforcement = enforcement;
  settings.standard.motion = MotionRule::equilibrium;
  Scene scene = mixed_scene_of(blocks, {0}, analysis, settings, 14, CoverFunctions::derived);
  for (VertexIndex v : indices(scene.model.vertices)) {
    const Point p = scene.model.start_vertices[static_cast<std::size_t>(v.value)];
    const ElementIndex e = scene.model.vertices[v].element;
    if (p == Point{-2, -1} || p == Point{-2, 1}) scene.model.fixed_points.push_back({p, e, {}});
    if (p == Point{kLength, kHalf + kHeight}) scene.model.loading_points.push_back({p, e, {{0}, {{0, -force}}, {}}});
    if (p == Point{kLength, -kHalf - kHeight}) scene.model.loading_points.push_back({p, e, {{0}, {{0, force}}, {}}});
  }
  return scene;
}

struct Tips {
  double upper = 0;  ///< y of the lower corner of the upper tine
  double lower = 0;
};

Tips tips_of(const Scene& scene) {
  StandardStepper stepper(scene);
  support::run_to(stepper, 1e-3);
  Tips tips;
  for (VertexIndex v : indices(scene.model.vertices)) {
    const Point p = scene.model.start_vertices[static_cast<std::size_t>(v.value)];
    if (p == Point{kLength, kHalf}) tips.upper = stepper.state().vertices[v].y;
    if (p == Point{kLength, -kHalf}) tips.lower = stepper.state().vertices[v].y;
  }
  return tips;
}

TEST(SelfContact, tines_that_do_not_meet_bend_as_beams) {
  const Tips tips = tips_of(fork(force_of(kHalf / 2), Enforcement::lagrange));
  // The stem gives way: 8 % more, and 1 % by shear.
  EXPECT_NEAR((kHalf - tips.upper) / (kHalf / 2), 1.09, 0.05);
  EXPECT_NEAR(tips.upper, -tips.lower, 5e-3 * kHalf);  // the mesh is rotated: it has no mirror image
}

TEST(SelfContact, tines_that_meet_do_not_pass_through_each_other) {
  for (const Enforcement enforcement : {Enforcement::lagrange, Enforcement::penalty}) {
    const Tips tips = tips_of(fork(force_of(3 * kHalf), enforcement));
    EXPECT_NEAR(tips.upper - tips.lower, 0, enforcement == Enforcement::lagrange ? 1e-7 * kLength : 1e-4 * kGap);
    EXPECT_NEAR(tips.upper, 0, 0.02 * kHalf);
  }
}

}  // namespace
}  // namespace keyblock::self_contact_test
