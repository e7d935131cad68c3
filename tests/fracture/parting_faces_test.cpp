// Faces of a crack as they part: the energy that they take, and the time of parting.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/parting_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace keyblock::parting_faces_test {
namespace {

constexpr double kEnergy = 0.04, kModulus = 2e4;

// From (0, 0) to (0.3, 0): the rock to its right, below, pulls the left face by `traction`.
PartingFaces faces_under(Point traction) {
  PartingFaces faces = parting_faces({0, 0}, {0.3, 0}, kEnergy, kModulus, {0.3, 0}, [&](Point) { return traction; });
  for (PartingPoint& point : faces.points) {
    point.left = 0;
    point.right = 1;
  }
  return faces;
}

DisplacementAt apart_by(Point opening) {
  return [opening](int element, Point) { return element == 0 ? opening : Point{}; };
}

/// A body of the left face that moves freely except for the pulls; the right one is fixed.
struct Mover {
  double mass = 1;
  Point at = {};
  Point speed = {};

  double energy() const { return mass * dot(speed, speed) / 2; }
};

/// Makes one step under a constant force; returns the work that the pulls took.
double step(PartingFaces& faces, Mover& mover, double dt) {
  std::vector<PartingFaces> all{faces};
  PullsOfStep search(all);
  const auto end_under = [&](const std::vector<Point>& pulls) {
    Point force;
    for (const Point pull : pulls) force = force + pull;
    Mover end = mover;
    end.at = mover.at + dt * mover.speed + (dt * dt / (2 * mover.mass)) * force;
    end.speed = mover.speed + (dt / mover.mass) * force;
    return end;
  };
  Mover end = end_under(search.pulls().front());
  while (!search.are_found(apart_by(end.at))) end = end_under(search.pulls().front());
  const double before = faces.taken;
  part(faces, search.pulls().front(), apart_by(end.at));
  mover = end;
  return faces.taken - before;
}

// The opening of a tip at its toughness, 8 K/E' √(r/2π), with K = √(E' Γ/l) and r = l (Irwin 1957).
const double kAtToughness = 8 * std::sqrt(kEnergy / kModulus / (2 * std::numbers::pi));
// A traction that the linear law lets go at the opening of a tip: t δ l / 2 = Γ.
const Point kTraction{0, -2 * kEnergy / (kAtToughness * 0.3)};

// With three times Γ a body leaves with two; steps are from a hundredth of the way to one that goes far beyond it.
TEST(PartingFaces, take_their_energy_whatever_the_step) {
  for (const Point direction : {Point{0, 1}, Point{0.8, 0.6}, Point{-1, 0}})
    for (const double way : {0.01, 0.1, 0.4, 1.0, 3.0}) {
      PartingFaces faces = faces_under(kTraction);
      Mover mover{1, {}, std::sqrt(6 * kEnergy) * direction};
      double least = 0;
      for (int i = 0; i < 4000 && !faces.have_parted(); ++i) {
        step(faces, mover, way * kAtToughness / length(mover.speed));
        least = std::min(least, faces.taken);
      }
      EXPECT_TRUE(faces.have_parted());
      EXPECT_NEAR(faces.taken, kEnergy, 2e-3 * kEnergy) << way << " " << direction.x;
      EXPECT_LE(faces.taken, (1 + 1e-8) * kEnergy) << way << " " << direction.x;
      EXPECT_NEAR(mover.energy(), 3 * kEnergy - faces.taken, 1e-9 * kEnergy);
      EXPECT_GE(least, -1e-8 * kEnergy);
      EXPECT_LT(length(mover.at), (way + 2) * kAtToughness) << "long before they lie wide open";
    }
}

/// Two bodies tied by most of their mass, so that a pull on one moves the other: inverse masses 1 and 0.8.
struct TiedMovers {
  double at[2] = {0, 0};
  double speed[2] = {0, 0};

  TiedMovers after(double dt, const Pulls& pulls) const {
    TiedMovers end = *this;
    for (int k = 0; k < 2; ++k)
      for (int of = 0; of < 2; ++of)
        for (const Point pull : pulls[of]) {
          const double acceleration = (k == of ? 1 : 0.8) * pull.y;
          end.speed[k] += dt * acceleration;
          end.at[k] += dt * dt / 2 * acceleration;
        }
    for (int k = 0; k < 2; ++k) end.at[k] += dt * speed[k];
    return end;
  }
  double energy() const {
    return (speed[0] * speed[0] + speed[1] * speed[1] - 1.6 * speed[0] * speed[1]) / (2 * (1 - 0.8 * 0.8));
  }
};

// A search piece by piece takes up to 14 iterations here, and must not let a piece pull less in the step.
TEST(PartingFaces, that_move_each_other_take_their_energy_in_few_rounds) {
  for (const double way : {0.05, 0.3, 1.0}) {
    std::vector<PartingFaces> all{faces_under(kTraction), faces_under(0.5 * kTraction)};
    for (PartingPoint& point : all[1].points) point.left = 2;
    TiedMovers movers{{0, 0}, {std::sqrt(12 * kEnergy), std::sqrt(12 * kEnergy)}};
    const double first = movers.energy(), dt = way * kAtToughness / movers.speed[0];
    int most = 0;
    for (int i = 0; i < 400; ++i) {
      PullsOfStep search(all);
      TiedMovers end;
      const DisplacementAt apart = [&](int element, Point) { return Point{0, element == 1 ? 0 : end.at[element / 2]}; };
      int rounds = 0;
      do {
        end = movers.after(dt, search.pulls());
        ++rounds;
      } while (!search.are_found(apart));
      most = std::max(most, rounds);
      for (int k = 0; k < 2; ++k) part(all[k], search.pulls()[k], apart);
      movers = end;
      ASSERT_NEAR(movers.energy() + all[0].taken + all[1].taken, first, 1e-9 * first);
    }
    EXPECT_LE(most, 8) << way;
    for (const PartingFaces& faces : all) {
      EXPECT_TRUE(faces.have_parted());
      EXPECT_NEAR(faces.taken, kEnergy, 2e-3 * kEnergy) << way;
    }
  }
}

// With half of Γ the pulls hold it; it oscillates and never has more energy than it began with.
TEST(PartingFaces, that_swing_make_no_energy) {
  for (const double way : {0.02, 0.3, 2.0}) {
    PartingFaces faces = faces_under(kTraction);
    Mover mover{1, {}, {0, std::sqrt(kEnergy)}};
    for (int i = 0; i < 300; ++i) {
      step(faces, mover, way * kAtToughness / std::sqrt(kEnergy));
      ASSERT_GE(faces.taken, -1e-8 * kEnergy) << way << " " << i;
      ASSERT_LE(mover.energy(), 0.5 * kEnergy * (1 + 1e-8));
    }
  }
}

// Faces that slide in the direction of their pull are not driven on.
TEST(PartingFaces, that_move_with_their_pull_are_given_no_energy) {
  for (const double way : {0.02, 0.3, 2.0}) {
    PartingFaces faces = faces_under({kTraction.y, 0});
    Mover mover{1, {}, {-std::sqrt(kEnergy) / 10, 0}};
    const double first = mover.energy();
    for (int i = 0; i < 100; ++i) {
      step(faces, mover, way * kAtToughness / std::sqrt(kEnergy));
      ASSERT_LE(mover.energy(), first * (1 + 1e-8)) << way << " " << i;
    }
    EXPECT_GE(faces.taken, -1e-8 * kEnergy);
  }
}

TEST(PartingFaces, that_were_pressed_as_they_parted_are_free_once_they_lie_wide_open) {
  PartingFaces faces = faces_under({0, 1});
  const std::vector<Point> none(faces.points.size());
  part(faces, none, apart_by({0, kAtToughness}));
  EXPECT_FALSE(faces.have_parted());
  part(faces, none, apart_by({0, 5 * kAtToughness}));
  EXPECT_TRUE(faces.have_parted());
  EXPECT_EQ(faces.taken, 0);
}

}  // namespace
}  // namespace keyblock::parting_faces_test
