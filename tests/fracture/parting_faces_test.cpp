// Faces that let go of each other: what they take, and when they have parted.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/parting_faces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keyblock::parting_faces_test {
namespace {

constexpr double kEnergy = 0.04, kModulus = 2e4;

// From (0, 0) to (0.3, 0): what lies to the right of it, below, pulls the left face by `traction`.
PartingFaces faces_under(Point traction) {
  PartingFaces faces = parting_faces({0, 0}, {0.3, 0}, kEnergy, kModulus, {0.3, 0}, [&](Point) { return traction; });
  for (PartingPoint& point : faces.points) {
    point.left = 0;
    point.right = 1;
  }
  return faces;
}

/// Apart by `opening`, the left face upward.
void open(PartingFaces& faces, double opening) {
  let_go(faces, [&](int element, Point) { return Point{0, element == 0 ? opening : 0}; });
}

// The opening of a tip at its toughness, 8 K/E' √(r/2π), with K = √(E' Γ/l) and r = l (Irwin 1957).
const double kAtToughness = 8 * std::sqrt(kEnergy / kModulus / (2 * std::numbers::pi));

TEST(PartingFaces, take_their_energy_long_before_they_lie_wide_open) {
  // A traction that the linear law lets go at the opening of a tip: t δ l / 2 = Γ.
  PartingFaces faces = faces_under({0, -2 * kEnergy / (kAtToughness * 0.3)});
  double opening = 0;
  while (!faces.have_parted() && opening < 2 * kAtToughness) open(faces, opening += kAtToughness / 500);
  EXPECT_TRUE(faces.have_parted());
  EXPECT_NEAR(faces.taken, kEnergy, 0.01 * kEnergy);
  EXPECT_LT(opening, 1.2 * kAtToughness);
}

TEST(PartingFaces, that_were_pressed_as_they_parted_are_free_once_they_lie_wide_open) {
  PartingFaces faces = faces_under({0, 1});
  open(faces, kAtToughness);
  EXPECT_FALSE(faces.have_parted());
  open(faces, 5 * kAtToughness);
  EXPECT_TRUE(faces.have_parted());
  EXPECT_EQ(faces.taken, 0);
}

}  // namespace
}  // namespace keyblock::parting_faces_test
