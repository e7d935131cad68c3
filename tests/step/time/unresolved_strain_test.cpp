// Rows of stiff blocks that meet at random in steps ten times longer than their slowest vibration: their energy falls.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/unresolved_strain.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock {
namespace {

std::string box(Point low, Point high, int material) {
  return fmt::format(R"({{"material": {}, "outer": [[{}, {}, 1], [{}, {}, 1], [{}, {}, 1], [{}, {}, 1]]}})", material,
                     low.x, low.y, high.x, low.y, high.x, high.y, low.x, high.y);
}

// `count` blocks of 2 by 1 m, E 40 GPa, in a corner without weight, a micrometre apart, each with a velocity of up to
// 1 m/s and 0.5 rad/s. The slowest strain mode has 25 periods a step of 10 ms.
std::string row_that_meets_at_random(int count, unsigned seed) {
  const std::string rock = R"("density": 2500, "unit_weight": 0, "youngs_modulus": 4e10, "poissons_ratio": 0.3)";
  std::string blocks = box({-2, -1}, {2.0 * count + 20, 0}, 1) + ", " + box({-2, 0}, {0, 1}, 1);
  std::string materials = "{" + rock + "}";
  std::minstd_rand dice(seed);
  const auto of_one = [&] { return 2.0 * (dice() - dice.min()) / (dice.max() - dice.min()) - 1; };
  for (int i = 0; i < count; ++i) {
    const double x = of_one(), y = of_one(), turn = of_one() / 2;
    materials += fmt::format(R"(, {{{}, "initial_velocity": [{}, {}, {}]}})", rock, x, y, turn);
    const Point at{2.0 * i + 1e-6 * (2 * i + 2 + of_one()), 1e-6 * (2 + of_one())};
    blocks += ", " + box(at, at + Point{2, 1}, i + 2);
  }
  return fmt::format(R"({{"keyblock": 1, "blocks": {{"blocks": [{}], "fixed_points": [[-1, -0.8, 1], [{}, -0.2, 1],
    [-1.6, 0.2, 2], [-0.4, 0.8, 2]]}}, "analysis": {{"velocity_carry_over": 1, "step_count": 60, "time_step": 0.01,
    "allowed_displacement_ratio": 1, "block_materials": [{}], "joint_materials": [{{"friction_angle_deg": 0}}]}},
    "run": {{"set": {{"gravity": 0}}}}}})",
                     blocks, 2.0 * count, materials);
}

// Strain rates left by impacts became strain: energies grew a hundredfold in each step, up to the first crushed block.
// What is left is an overlap that three blocks close against their elasticity, in one row of six; the run says so.
TEST(UnresolvedStrain, rows_of_stiff_blocks_that_meet_at_random_do_not_explode) {
  const std::string folder = support::fresh_folder("unresolved");
  int doubted = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    support::write_text(folder + "/row.json", row_that_meets_at_random(20, seed));
    const support::ProgramRun run =
        support::run_keyblock({"run", folder + "/row.json", "-o", folder + "/out", "--force", "--no-pictures"});
    ASSERT_LE(run.exit_code, 1) << "seed " << seed << ": " << run.messages;
    if (run.exit_code == 0) continue;
    ++doubted;
    const std::string words = "energy came from nothing: ";  // over the largest stored energy
    const std::size_t at = run.messages.find(words);
    ASSERT_NE(at, std::string::npos) << run.messages;
    EXPECT_LT(std::stod(run.messages.substr(at + words.size())), 0.1) << "seed " << seed;
  }
  EXPECT_LE(doubted, 1);
}

Body unit_body(double frequency) {
  Body body;
  body.mass = UnknownBlock::Identity(6, 6);
  body.mass(2, 5) = body.mass(5, 2) = 0.5;  // shear turns a block that is not square
  body.stiffness = Body::Stiffness::Identity(3, 3);
  body.slowest_frequency = frequency;
  return body;
}

TEST(UnresolvedStrain, rates_end_if_two_periods_are_shorter_than_the_step_and_momenta_stay) {
  Bodies bodies;
  bodies.push_back(unit_body(13));
  bodies.push_back(unit_body(12));
  UnknownsTable v;
  for (int i = 0; i < 2; ++i) v.push_back(Unknowns::LinSpaced(6, 1, 6));
  const Unknowns momentum = bodies[ElementIndex{0}].mass * v[ElementIndex{0}];
  stop_unresolved(bodies, 1, v);
  EXPECT_EQ(v[ElementIndex{0}].tail(3), Eigen::Vector3d::Zero());
  EXPECT_NEAR((bodies[ElementIndex{0}].mass * v[ElementIndex{0}] - momentum).head(3).norm(), 0, 1e-14);
  EXPECT_EQ(v[ElementIndex{1}], Unknowns(Unknowns::LinSpaced(6, 1, 6)));
}

}  // namespace
}  // namespace keyblock
