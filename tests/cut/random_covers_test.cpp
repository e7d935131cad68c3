// Random drawings keep the properties of a cut mesh, also with joints on mesh lines and without merging.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "cut/bodies/cut_blocks.hpp"
#include "cut/covers/cut_cover.hpp"
#include "cut/mesh/background_mesh.hpp"
#include "tests/cut/drawings.hpp"
#include "tests/cut/manifolds.hpp"
#include "tests/validate/dice.hpp"

namespace keyblock::random_covers_test {
namespace {

const Box kBox{{0, 0}, {1, 1}};

/// The unit square with a hole or none, and joints of all lengths.
Drawing square_with_joints(Dice& dice, const std::vector<Segment>& joints, double edge_node_ratio) {
  const double x = dice.between(0.2, 0.6);
  const double y = dice.between(0.2, 0.6);
  const bool has_hole = dice.happens(0.5);
  std::vector<Segment> lines = rectangle_sides(kBox.low, kBox.high);
  if (has_hole) lines = lines + rectangle_sides({x, y}, {x + dice.between(0.001, 0.3), y + dice.between(0.001, 0.3)});
  Drawing drawing = drawing_of(lines + joints, edge_node_ratio);
  drawing.boundary_count = lines.size();
  return drawing;
}

std::vector<Segment> random_joints(Dice& dice) {
  std::vector<Segment> joints;
  for (int i = dice.below(12); i > 0; --i) {
    joints.push_back({{dice.between(0, 1), dice.between(0, 1)}, {dice.between(0, 1), dice.between(0, 1)}});
  }
  return joints;
}

/// Between nodes of the mesh, most of them along its lines.
std::vector<Segment> joints_on_mesh(Dice& dice, const RegularMesh& mesh) {
  std::vector<Segment> joints;
  const auto node = [&](int i, int j) {
    const Point p{mesh.dx * (i + 0.5 * j), mesh.dy * j};
    return mesh.through + Point{std::cos(mesh.angle) * p.x - std::sin(mesh.angle) * p.y,
                                std::sin(mesh.angle) * p.x + std::cos(mesh.angle) * p.y};
  };
  for (int tries = 0; tries < 200 && joints.size() < 8; ++tries) {
    const int i = dice.below(21) - 10;
    const int j = dice.below(21) - 10;
    const int reach = 1 + dice.below(6);
    const Point a = node(i, j);
    const int way = dice.below(4);
    const Point b = way == 0   ? node(i + reach, j)
                    : way == 1 ? node(i, j + reach)
                    : way == 2 ? node(i - reach, j + reach)
                               : node(i + reach, j + reach);
    if (kBox.holds(a) && kBox.holds(b)) joints.push_back({a, b});
  }
  return joints;
}

void expect_sound_cut(const Drawing& drawing, const RegularMesh& mesh) {
  const BodyCut bodies = cut_bodies(drawing);
  const Manifold manifold = cut_cover(bodies.graph, regular_triangles(kBox, mesh));
  expect_sound(manifold);
  ASSERT_EQ(manifold.body_materials.size(), bodies.blocks.blocks.blocks.size());
  const std::vector<double> areas = areas_of_bodies(manifold);
  for (std::size_t i = 0; i < areas.size(); ++i) EXPECT_NEAR(areas[i], area(bodies.blocks.blocks.blocks[i]), 1e-8);
  EXPECT_NEAR(area_within_loops(manifold), total_area(bodies.blocks.blocks), 1e-8);
}

RegularMesh random_mesh(Dice& dice) {
  RegularMesh mesh = centred_mesh(kBox, 1 + dice.below(6), dice.happens(0.5) ? MeshShape::equilateral : MeshShape::old);
  mesh.through = {dice.between(0, 1), dice.between(0, 1)};
  mesh.angle = dice.between(-1, 1);
  return mesh;
}

}  // namespace

TEST(RandomCovers, joints_anywhere_in_a_mesh_at_any_angle) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const std::vector<Segment> joints = random_joints(dice);
    const double ratio = seed % 3 == 0 ? 0 : seed % 3 == 1 ? 1e-9 : 1e-3;
    expect_sound_cut(square_with_joints(dice, joints, ratio), random_mesh(dice));
    if (testing::Test::HasFailure()) return;
  }
}

TEST(RandomCovers, joints_on_lines_of_the_mesh) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    RegularMesh mesh = random_mesh(dice);
    if (seed % 2 == 0) mesh = aligned_mesh(kBox, 1 + dice.below(6), MeshShape::equilateral);
    const std::vector<Segment> joints =
        joints_on_mesh(dice, mesh) + (seed % 5 == 0 ? random_joints(dice) : std::vector<Segment>{});
    expect_sound_cut(square_with_joints(dice, joints, seed % 3 == 0 ? 0 : 1e-9), mesh);
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace keyblock::random_covers_test
