// Factors of safety of bolted blocks on a plane, compared with limit equilibrium.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "formats/case.hpp"
#include "study/strength/factor_of_safety.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::study::bolted_blocks_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kWeightPerArea = 2500 * 9.81;
// Blocks strain and rotate a little before they slip, which changes the force of bolts: of 200 blocks the middle of no
// bracket was off by more than 0.36 %.
constexpr double kStrained = 0.004;
constexpr double kStiffness = 2e7;  // N/m per metre of thickness

/// A block of `length` along the plane and `height` across it. Points are given along the plane, upward, and across it;
/// its lower corner is the origin. The bolt pulls the block from `from` towards `to`.
struct Bolted {
  double plane, friction;  ///< rad
  double length, height;
  double cohesion;  ///< Pa
  Point from, to;
  double strength, pretension;  ///< N/m

  double weight() const { return kWeightPerArea * length * height; }
  double along() const { return (to - from).x / keyblock::length(to - from); }
  double inward() const { return -(to - from).y / keyblock::length(to - from); }
  double normal() const { return weight() * std::cos(plane) + strength * inward(); }
  /// The bolt pulls with `pull` along `bolt`; friction and `bond` over F resist along the base.
  double factor_under(double pull, Point bolt, double bond) const {
    const Point force = pull / keyblock::length(bolt) * bolt;
    return ((weight() * std::cos(plane) - force.y) * std::tan(friction) + bond * length) /
           (weight() * std::sin(plane) - force.x);
  }
  /// Before the block slips, with cohesion and the pretension; or after it, at the strength of the bolt, which the slip
  /// has stretched and rotated. A joint that slips has lost its cohesion.
  double factor() const {
    const Point bolt = to - from;
    const double stretched = keyblock::length(bolt) + (strength - pretension) / kStiffness;
    const Point at_strength{std::sqrt(stretched * stretched - bolt.y * bolt.y), bolt.y};
    return std::max(factor_under(pretension, bolt, cohesion), factor_under(strength, at_strength, 0));
  }
  /// Pressure on the base at the limit, from its middle over half its length.
  double eccentricity() const {
    const Point centre{length / 2, height / 2}, middle{length / 2, 0};
    const Point pull = strength / keyblock::length(to - from) * (to - from);
    const Point weight_force = weight() * Point{-std::sin(plane), -std::cos(plane)};
    const auto moment = [&](Point at, Point force) { return cross(at - middle, force); };
    return (moment(centre, weight_force) + moment(from, pull)) / normal() / (length / 2);
  }
};

class Draw {
 public:
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / static_cast<double>(std::mt19937::max());
  }

 private:
  std::mt19937 random_{7};
};

Bolted drawn(Draw& draw, int kind) {
  Bolted b{};
  b.plane = draw(20, 55) * kDegree;
  b.friction = draw(15, 45) * kDegree;
  b.length = draw(2, 4);
  b.height = draw(1, 3);
  b.cohesion = kind % 4 == 3 ? draw(0, 2e4) : 0;
  b.from = {draw(0.3, 0.9) * b.length, draw(0.1, 0.9) * b.height};
  // Across the plane; to the block above, rising or falling.
  b.to =
      kind % 2 == 0 ? Point{b.from.x + draw(0.5, 3), -draw(0.3, 2)} : Point{b.length + draw(1.2, 2.8), draw(0.2, 2.8)};
  b.strength = draw(0.05, 0.7) * b.weight() * std::sin(b.plane) / b.along();
  b.pretension = kind % 3 == 0 ? draw(0, 0.8) * b.strength : 0;
  return b;
}

/// Returns true if the block slides without rotation, a stronger bolt raises its factor, and the factor is of interest.
bool is_fit(const Bolted& b) {
  const bool helps = b.inward() * std::sin(b.plane) + b.along() * std::cos(b.plane) > 0.1;
  return helps && b.normal() > 0.2 * b.weight() && std::abs(b.eccentricity()) < 0.8 && b.factor() > 0.3 &&
         b.factor() < 6;
}

std::string case_of(const Bolted& b) {
  const auto at = [&](Point p) {
    return fmt::format("{}, {}", p.x * std::cos(b.plane) - p.y * std::sin(b.plane),
                       p.x * std::sin(b.plane) + p.y * std::cos(b.plane));
  };
  const auto block = [&](double left, double right, double low, double high) {
    return fmt::format(R"({{"outer": [[{}, 1], [{}, 1], [{}, 1], [{}, 1]]}})", at({left, low}), at({right, low}),
                       at({right, high}), at({left, high}));
  };
  const double l = b.length;
  return fmt::format(
      R"({{"keyblock": 2, "units": {{"length": "m", "mass": "kg", "time": "s"}}, "blocks": {{"blocks": [{}, {}, {}],
      "fixed_points": [[{}, 1], [{}, 1], [{}, 3], [{}, 3]],
      "bolts": [[{}, {}, 2, {}, 2e7, {}, {}]]}},
      "analysis": {{"step_count": 100, "time_step": 0.005, "gravity": 9.81,
      "block_materials": [{{"density": 2500, "youngs_modulus": 5e9, "poissons_ratio": 0.25}}],
      "joint_materials": [{{"friction_angle_deg": {}, "cohesion": {}}}]}}}})",
      block(-4, 10, -3, 0), block(0, l, 0, b.height), block(l + 1, l + 3, 0, 3), at({-3, -2}), at({9, -2}),
      at({l + 1.2, 2.8}), at({l + 2.8, 0.2}), at(b.from), at(b.to), b.to.y < 0 ? 1 : 3, b.strength, b.pretension,
      b.friction / kDegree, b.cohesion);
}

FactorOfSafety factor_of(const std::string& text, double within) {
  const std::string file = support::fresh_folder("bolted_blocks") + "/case.json";
  support::write_text(file, text);
  SearchOptions options;
  options.within = within;
  return factor_of_safety({configured_under("standard", {}, formats::load_case({file}).problem), Reduced::joints},
                          options);
}

}  // namespace

// Bolts stretch by centimetres before they reach their strength: displacements grow long before equilibrium ends.
TEST(BoltedBlocks, fall_where_limit_equilibrium_says) {
  Draw draw;
  int grew = 0;
  for (int made = 0; made < 20;) {
    const Bolted bolted = drawn(draw, made);
    if (!is_fit(bolted)) continue;
    ++made;
    SCOPED_TRACE(case_of(bolted));
    const double exact = bolted.factor();
    const FactorOfSafety found = factor_of(case_of(bolted), 0.004 * exact);
    ASSERT_EQ(found.end, SearchEnd::bracketed);
    EXPECT_LE(*found.bracket.stands, (1 + kStrained) * exact);
    EXPECT_GE(*found.bracket.falls, (1 - kStrained) * exact);
    EXPECT_LE(found.bracket.width(), 0.004 * exact * (1 + 1e-9));
    grew += found.grows_before_it_falls() ? 1 : 0;
  }
  EXPECT_GT(grew, 5) << "of 20 whose serviceability is reported too";
}

// W cos 35 tan 40 / (W sin 35 − 40 kN) with W = 147.15 kN, for any pretension. Without the bolt it slides beyond tan 40
// / tan 35.
TEST(BoltedBlocks, both_factors_are_told) {
  for (const double pretension : {0.0, 20e3}) {
    const Bolted bolted{35 * kDegree, 40 * kDegree, 3, 2, 0, {1.5, 1}, {4.5, 1}, 40e3, pretension};
    EXPECT_NEAR(bolted.factor(), 2.278, 0.001);
    const FactorOfSafety found = factor_of(case_of(bolted), 0.01);
    ASSERT_EQ(found.end, SearchEnd::bracketed);
    EXPECT_NEAR(found.bracket.middle(), 2.278, 0.01);
    ASSERT_TRUE(found.grows_before_it_falls());
    EXPECT_GT(*found.service.falls, std::tan(40 * kDegree) / std::tan(35 * kDegree));
    EXPECT_LT(*found.service.falls, 1.8);
    EXPECT_LE(found.service.width(), 0.01 * (1 + 1e-9));
    EXPECT_NE(fmt::format("{}", fmt::join(found.notes, "\n")).find("serviceability"), std::string::npos);
  }
}

}  // namespace keyblock::study::bolted_blocks_test
