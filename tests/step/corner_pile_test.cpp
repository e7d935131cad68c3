// A column of diamonds, with contacts of corners and faces only, falls apart on a fixed floor.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/ledger_runs.hpp"

namespace keyblock::corner_pile_test {
namespace {

using support::plain_analysis;
using support::rectangle;
using support::standard_scene_of;
using support::standard_settings;

constexpr double kSide = 0.4;
constexpr int kRows = 14;
constexpr double kDensity = 2500;
const double kHalf = kSide / std::sqrt(2.0);  // diagonal

// Rows of three and of two squares of side 0.4 on their corners, face on face.
Blocks column() {
  Blocks scene;
  scene.blocks = {rectangle({-12, -1}, {12, 0})};
  for (int row = 0; row < kRows; ++row) {
    const int count = row % 2 == 0 ? 3 : 2;
    for (int i = 0; i < count; ++i) {
      const Point foot{(2 * i - count + 1) * kHalf, row * kHalf};
      scene.blocks.push_back({1,
                              {{foot, 0},
                               {foot + Point{kHalf, kHalf}, 0},
                               {foot + Point{0, 2 * kHalf}, 0},
                               {foot + Point{-kHalf, kHalf}, 0}},
                              {}});
    }
  }
  for (BlockPolygon& block : scene.blocks) block.material = 0;
  scene.fixed_points = {{{-11, -0.5}, 0, {}}, {{11, -0.5}, 0, {}}};
  return scene;
}

using Corners = std::vector<Point>;

// Largest separation of b from an edge of a, counter-clockwise.
double separation(const Corners& a, const Corners& b) {
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point along = a[(i + 1) % a.size()] - a[i];
    double least = std::numeric_limits<double>::infinity();
    for (const Point p : b) least = std::min(least, -cross(along, p - a[i]) / length(along));
    most = std::max(most, least);
  }
  return most;
}

struct Pile {
  double deepest = 0;  ///< of two overlapping blocks, by separating axes
  double rise = 0;     ///< of the energy over the least before
  double lowest = 0;   ///< corner
  double reach = 0;    ///< of the farthest centres to both sides, on average
};

Corners corners_of(const Scene& scene, const State& state, ElementIndex e) {
  Corners corners;
  for (VertexIndex v : indices(scene.model.vertices))
    if (scene.model.vertices[v].element == e) corners.push_back(state.vertices[v]);
  return corners;
}

double deepest_at(const Scene& scene, const State& state) {
  std::vector<Corners> all;
  for (ElementIndex e : indices(scene.model.elements)) all.push_back(corners_of(scene, state, e));
  double deepest = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (j == 0 || distance(all[i][0], all[j][0]) < 4 * kHalf)
        deepest = std::max(deepest, -std::max(separation(all[i], all[j]), separation(all[j], all[i])));
  return deepest;
}

Scene column_scene(double dt, double time) {
  Analysis analysis = plain_analysis(dt, static_cast<int>(std::lround(time / dt)));
  analysis.joint_materials[0].friction_angle_deg = 25;
  analysis.block_materials[0].density = kDensity;
  analysis.block_materials[0].unit_weight = kDensity * 9.81;
  analysis.penalty_factor = 1;
  return standard_scene_of(column(), analysis, standard_settings(analysis));
}

Pile fallen(double dt, double time) {
  const Scene scene = column_scene(dt, time);
  StandardStepper stepper(scene);
  Pile pile;
  double least = std::numeric_limits<double>::infinity();
  double left = 0, right = 0;
  while (stepper.state().time < time - dt / 2) {
    support::run_to(stepper, stepper.state().time + dt);
    const LedgerRow row = stepper.ledger();
    const double energy = row.stored.kinetic + row.stored.strain + row.stored.gravity + row.stored.contact;
    pile.rise = std::max(pile.rise, energy - least);
    least = std::min(least, energy);
    pile.deepest = std::max(pile.deepest, deepest_at(scene, stepper.state()));
    left = right = 0;
    for (ElementIndex e : indices(scene.model.elements)) {
      if (e == ElementIndex{0}) continue;
      for (const Point p : corners_of(scene, stepper.state(), e)) pile.lowest = std::min(pile.lowest, p.y);
      const double x = stepper.state().elements[e].centroid.x;
      left = std::min(left, x);
      right = std::max(right, x);
    }
  }
  pile.reach = (right - left) / 2;
  return pile;
}

// Faces meet at nodes of four blocks, of which two have contact with their corners alone. Such pairs must not get lost
// while the glue of the initial state dissolves, or blocks slip past each other. Square corners with arcs between lines
// that begin at the rounding from them, a thousandth of half the side, overlap by up to √2 - 1 of it.
TEST(CornerPile, the_settled_start_leaves_no_block_in_another) {
  const Scene scene = column_scene(2e-3, 1);
  const StandardStepper stepper(scene);
  ASSERT_NE(stepper.start_report().made.find("glued under the loads and then released"), std::string::npos);
  EXPECT_LT(deepest_at(scene, stepper.state()), (std::sqrt(2.0) - 1) * 1e-3 * kSide / 2);
}

// Blocks must not penetrate. They once did by a third of their size, and fell through the floor. Later a jump drove
// corners past each other that did not lie over their edges before it, or pushed a block off one neighbour into another
// one: 9 mm at 3.9 ms. A falling column is chaotic, but of sixty runs, ten steps and six changes of round-off, none
// went 0.4 % of a side deep.
// Granular columns of this shape run out by about 1.9 a^(2/3) = 5 of their half-widths (Lube, Huppert, Sparks and
// Freundt 2005: a = H/r0 = 5, axially symmetric and of many grains). The path of the outermost blocks is chance too,
// between 3.2 and 5.4, so that the test takes the mean of four steps.
TEST(CornerPile, diamonds_keep_their_contacts_and_come_to_rest_on_the_floor) {
  const double weight = 35 * kDensity * kSide * kSide * 9.81;
  const double height = (kRows + 1) * kHalf;
  const double half_width = 3 * kHalf;
  const std::vector<double> steps{4.4e-3, 4e-3, 3.9e-3, 3.6e-3};
  double run_out = 0;
  for (const double dt : steps) {
    const Pile pile = fallen(dt, 3);
    EXPECT_LT(pile.deepest, 0.01 * kSide) << dt;
    EXPECT_GT(pile.lowest, -0.01 * kSide) << dt;
    EXPECT_LT(pile.rise, 1e-6 * weight * height) << dt;
    run_out += (pile.reach - half_width) / static_cast<double>(steps.size());
  }
  EXPECT_GT(run_out, 2 * half_width);
  EXPECT_LT(run_out, 5 * half_width);
}

}  // namespace
}  // namespace keyblock::corner_pile_test
